// The derivatives of the coordinates of a screw, one by one.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/numbers/dual_vector.hpp"
#include "screw/wrench.hpp"

namespace kinestat {

/// The three coordinates that begin a screw, and the three that end it.
inline std::array<const Vec3Of<Dual>*, 2> halves(const TwistOf<Dual>& twist) {
  return {&twist.angular, &twist.linear};
}

inline std::array<const Vec3Of<Dual>*, 2> halves(const WrenchOf<Dual>& wrench) {
  return {&wrench.moment, &wrench.force};
}

/// Calls slope(p, i, d coordinate i / d parameter p) for every parameter that moves a coordinate of
/// the screw.
template <class Screw, class Slope>
void for_each_slope(const Screw& screw, const Slope& slope) {
  int i = 0;
  for (const Vec3Of<Dual>* half : halves(screw)) {
    for (const Dual& coordinate : *half) {
      const std::vector<double>& by_parameter = coordinate.derivatives;
      for (std::size_t p = 0; p < by_parameter.size(); ++p) {
        if (by_parameter[p] != 0.0) {
          slope(p, i, by_parameter[p]);
        }
      }
      ++i;
    }
  }
}

}  // namespace kinestat
