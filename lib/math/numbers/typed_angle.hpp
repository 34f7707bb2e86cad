// Sine, cosine and tangent of an angle that was typed.
#pragma once

#include <cmath>

#include "core/angle_tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

/// Of angles so large that their rounding is no small part of a turn nothing is told zero.
inline double rounding_of_angle(double angle) {
  const double rounding = kAngleRounding * std::abs(angle);
  return rounding < kCoarseAngle ? rounding : 0.0;
}

/// The sine, which moves at most as far as the rounding of its angle: zero, with its sign, where
/// that is all that it is, as of 180 deg, for which no double stands.
inline double sine(double angle) {
  const double value = std::sin(angle);
  return std::copysign(zero_within_bound(value, rounding_of_angle(angle)), value);
}

/// The cosine: zero likewise, as of 90 deg.
inline double cosine(double angle) {
  const double value = std::cos(angle);
  return std::copysign(zero_within_bound(value, rounding_of_angle(angle)), value);
}

/// The tangent: zero with its sine.
inline double tangent(double angle) {
  const double value = std::tan(angle);
  return sine(angle) == 0.0 ? std::copysign(0.0, value) : value;
}

}  // namespace kinestat
