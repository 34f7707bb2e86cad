// Which coordinates of a synthesis task are rounding of its positions.
#pragma once

#include <cmath>

namespace kinestat {

/// The value, or +0 if it is below what rounding leaves open.
inline double snap(double value, double rounding) {
  return std::abs(value) <= rounding ? 0.0 : value;
}

}  // namespace kinestat
