// Sine, cosine and tangent of an angle that was typed.
#pragma once

#include <cmath>

#include "core/angle_tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

/// The sine, which moves at most as far as the rounding of its angle: zero where that is all that
/// it is, as of 180 deg, for which no double stands.
inline double sine(double angle) {
  return zero_within_bound(std::sin(angle), kAngleRounding * std::abs(angle));
}

/// The cosine: zero likewise, as of 90 deg.
inline double cosine(double angle) {
  return zero_within_bound(std::cos(angle), kAngleRounding * std::abs(angle));
}

/// The tangent: zero with its sine.
inline double tangent(double angle) {
  return sine(angle) == 0.0 ? 0.0 : std::tan(angle);
}

}  // namespace kinestat
