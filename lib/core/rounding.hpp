// What rounding has done to numbers before any mechanics was computed from them.
#pragma once

#include "core/tolerance.hpp"

namespace kinestat {

/// Coordinates and directions may be off by this share of their largest: the formulas of the file
/// and the step to unit screws round a few times.
inline constexpr double kDataRounding = 4 * kEpsilon;

/// A solved magnitude without a bound of its own counts as off by this share of itself. That is
/// what its last operations round; how its equations magnify errors is not in it.
inline constexpr double kSolvedRounding = 8 * kEpsilon;

}  // namespace kinestat
