// Vectors of numbers with many digits.
#pragma once

#include <array>
#include <cstddef>

#include "math/numbers/big_float.hpp"

namespace kinestat {

using PreciseVector = std::array<BigFloat, 3>;

template <std::size_t n>
BigFloat dot(const std::array<BigFloat, n>& a, const std::array<BigFloat, n>& b) {
  BigFloat sum(0);
  for (std::size_t i = 0; i < n; ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

inline PreciseVector cross(const PreciseVector& a, const PreciseVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace kinestat
