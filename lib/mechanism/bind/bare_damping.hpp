// Damping numbers that are typed without a unit.
#pragma once

#include <string_view>

#include "core/diagnostic.hpp"
#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// The factor from a bare number to SI: the file's unit of moment over that of angular velocity if
/// `turns`, otherwise its unit of force over that of velocity.
double bare_damping_unit(const FileUnits& units, bool turns);

/// Adds W0313 if such a number is not zero and its unit of speed is not rad/s or m/s. `title` names
/// the number, "'damping' of spring 's'". `value` must have a value.
void warn_of_bare_damping(const Value& value,
                          std::string_view title,
                          bool turns,
                          const FileUnits& units,
                          Evaluator& evaluator,
                          Diagnostics& found);

}  // namespace kinestat
