// A number of a mechanism file from the places of its parameters.
#pragma once

#include <optional>
#include <vector>

#include "expression/file_units.hpp"
#include "expression/slots.hpp"

namespace kinestat {

/// [SI], with the bits of an Evaluator; empty where that has an error. `scratch` is kept by the
/// caller, so that evaluating allocates nothing.
std::optional<double> slot_number(const SlotExpression& value,
                                  QuantityKind kind,
                                  const FileUnits& units,
                                  const Slots& slots,
                                  std::vector<Quantity>& scratch);

}  // namespace kinestat
