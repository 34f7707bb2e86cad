// How well a typed angle is known.
#pragma once

#include "core/tolerance.hpp"

namespace kinestat {

/// An angle is rounded by no more than this share of itself: once with pi, once by its unit, and by
/// a sum or product or two. Less than one in the fifteenth digit, so that what is typed with so
/// many counts.
inline constexpr double kAngleRounding = 4 * kEpsilon;

}  // namespace kinestat
