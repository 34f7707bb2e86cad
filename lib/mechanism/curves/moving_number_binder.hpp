// Numbers of a description that may follow curves.
#pragma once

#include <optional>
#include <span>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/curves/curve.hpp"
#include "mechanism/curves/moving_number.hpp"

namespace kinestat {

/// Whether a number uses a curve of the file.
bool names_curve(const Value& value, const MechanismDescription& description);

/// Binds a number. Empty iff an error was added, for the number or for a curve that it uses.
std::optional<MovingNumber> bind_moving_number(const Value& value,
                                               QuantityKind kind,
                                               std::span<const Curve> curves,
                                               Evaluator& evaluator);

}  // namespace kinestat
