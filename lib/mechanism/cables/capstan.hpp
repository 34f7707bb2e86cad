// The capstan equation of Euler and Eytelwein.
#pragma once

#include <cmath>

namespace kinestat {

/// The ratio of the tension ahead of a pulley to that behind it at which the cable slips: e^(μ θ),
/// for a coefficient of friction μ and an angle of wrap θ [rad]. 1 without friction.
inline double capstan_ratio(double friction, double wrap) {
  return std::exp(friction * wrap);
}

}  // namespace kinestat
