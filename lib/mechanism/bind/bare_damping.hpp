// Dampings that are typed without a unit.
#pragma once

#include <string_view>

#include "core/diagnostic.hpp"
#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

/// What a bare number is times in SI: a couple per angular velocity, or a force per velocity, in
/// the units of the file.
double bare_damping_unit(const FileUnits& units, bool turns);

/// W0313 where such a number is not zero and counts by another speed than rad/s or m/s. `title`
/// says whose it is, "'damping' of spring 's'"; `value` must have a value.
void warn_of_bare_damping(const Value& value,
                          std::string_view title,
                          bool turns,
                          const FileUnits& units,
                          Evaluator& evaluator,
                          Diagnostics& found);

}  // namespace kinestat
