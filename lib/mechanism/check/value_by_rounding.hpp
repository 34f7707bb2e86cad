// Numbers that have a value only by rounding.
#pragma once

#include "core/diagnostic.hpp"
#include "description/value.hpp"

namespace kinestat {

/// Adds E0316 for a number that has a value in arithmetic with 16 digits but none in exact
/// arithmetic, such as 1/ln(1.1*1.1/1.21).
void refuse_value_by_rounding(const Value& value, Diagnostics& found);

}  // namespace kinestat
