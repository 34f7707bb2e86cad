// Laws by which drives run from rest to rest.
#pragma once

namespace kinestat {

/// In the order of their words in files. s(u) is the share of the range at the share u of the time
/// (Norton, Design of Machinery, chapter 8).
enum class DriveLaw {
  constant_speed,         ///< s = u: speed jumps at both ends
  constant_acceleration,  ///< half of the time speeding up, half slowing down
  trapezoid,              ///< speeds up in `ramp` of the time, then runs steadily, then slows down
  polynomial_345,         ///< 10 u³ - 15 u⁴ + 6 u⁵
  polynomial_4567,        ///< 35 u⁴ - 84 u⁵ + 70 u⁶ - 20 u⁷
  cycloidal,              ///< u - sin(2 π u)/(2 π)
  harmonic,               ///< (1 - cos π u)/2
  modified_trapezoid,     ///< acceleration of sines and plateaus
  modified_sine           ///< acceleration of two sines
};

inline constexpr double kUsualRamp = 1.0 / 3.0;

}  // namespace kinestat
