// The largest of some magnitudes.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace kinestat {

/// Zero where there are none.
inline double largest(std::span<const double> values) {
  double result = 0.0;
  for (const double value : values) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

}  // namespace kinestat
