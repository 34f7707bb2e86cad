// How well a typed angle is known.
#pragma once

#include "core/tolerance.hpp"

namespace kinestat {

/// An angle is rounded by no more than this share of itself: once with pi, once by its unit, and by
/// a sum or product or two. Less than one in the fifteenth digit, so that what is typed with so
/// many counts.
inline constexpr double kAngleRounding = 4 * kEpsilon;

/// An angle that is rounded by as much as this is not known to be a multiple of anything.
inline constexpr double kCoarseAngle = 1e-3;

}  // namespace kinestat
