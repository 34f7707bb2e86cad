// The value of a number of a mechanism file for given parameters.
#pragma once

#include <optional>
#include <vector>

#include "expression/file_units.hpp"
#include "expression/slots.hpp"

namespace kinestat {

/// Evaluates a number [SI] with the same bits as an Evaluator; empty if that adds an error. The
/// caller keeps `scratch`, so that evaluation allocates nothing.
std::optional<double> slot_number(const SlotExpression& value,
                                  QuantityKind kind,
                                  const FileUnits& units,
                                  const Slots& slots,
                                  std::vector<Quantity>& scratch);

}  // namespace kinestat
