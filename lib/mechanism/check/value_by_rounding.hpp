// A number that is none without rounding.
#pragma once

#include "core/diagnostic.hpp"
#include "description/value.hpp"

namespace kinestat {

/// E0316 for a value of which arithmetic with 16 digits made a number, and exact arithmetic none:
/// 1/(0.1 + 0.2 - 0.3).
void refuse_value_by_rounding(const Value& value, Diagnostics& found);

}  // namespace kinestat
