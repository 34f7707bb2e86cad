// The capstan equation of Euler and Eytelwein.
#pragma once

#include <cmath>

namespace kinestat {

/// The ratio of the larger to the smaller tension at which a cable slips on a pulley: e^(μ θ), for
/// a coefficient of friction μ and an angle of wrap θ [rad]. 1 without friction.
inline double capstan_ratio(double friction, double wrap) {
  return std::exp(friction * wrap);
}

}  // namespace kinestat
