// The one rule for zero.
#pragma once

#include <cmath>

namespace kinestat {

/// A value is zero where its own error bound says so; otherwise it stays as it is. To be asked
/// where the value is made, and nowhere else.
inline double zero_within_bound(double value, double bound) {
  return std::isfinite(bound) && std::abs(value) <= bound ? 0.0 : value;
}

}  // namespace kinestat
