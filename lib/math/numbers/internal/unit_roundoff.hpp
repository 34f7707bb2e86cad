// Rounding to the nearest double.
#pragma once

#include "core/tolerance.hpp"

namespace kinestat {

/// The largest relative error of one rounding.
inline constexpr double kUnitRoundoff = kEpsilon / 2.0;

}  // namespace kinestat
