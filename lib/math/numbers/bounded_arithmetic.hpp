// The arithmetic of numbers and vectors with bounds in place, where there are many of them.
#pragma once

#include <cmath>
#include <limits>

#include "math/numbers/bounded_number.hpp"
#include "math/numbers/internal/unit_roundoff.hpp"

namespace kinestat {

/// For the few roundings of a bound itself.
inline constexpr double kWithinBound = 1.0 + 16.0 * kUnitRoundoff;

inline bool is_sure_zero(const BoundedNumber& number) {
  return number.value == 0.0 && number.bound == 0.0;
}

/// With the rounding of the value, which may have been below the smallest number. Nothing is known
/// where infinite bounds meet zeros.
inline BoundedNumber with_rounding(double value, double bound) {
  const double rounding =
      kUnitRoundoff * std::abs(value) + std::numeric_limits<double>::denorm_min();
  const double all = (bound + rounding) * kWithinBound;
  return {.value = value, .bound = all >= 0.0 ? all : std::numeric_limits<double>::infinity()};
}

inline BoundedNumber bounded_sum(const BoundedNumber& a, const BoundedNumber& b) {
  const double sum = a.value + b.value;
  const double bound = a.bound + b.bound;
  return sum == 0.0 && bound == 0.0 ? BoundedNumber{} : with_rounding(sum, bound);
}

inline BoundedNumber bounded_difference(const BoundedNumber& a, const BoundedNumber& b) {
  return bounded_sum(a, {.value = -b.value, .bound = b.bound});
}

inline BoundedNumber bounded_product(const BoundedNumber& a, const BoundedNumber& b) {
  if (is_sure_zero(a) || is_sure_zero(b)) {
    return {};
  }
  return with_rounding(
      a.value * b.value,
      std::abs(a.value) * b.bound + std::abs(b.value) * a.bound + a.bound * b.bound);
}

template <class Component>
BoundedVector bounded_by_component(const Component& component) {
  BoundedVector result;
  for (int i = 0; i < 3; ++i) {
    const BoundedNumber one = component(i);
    result.value[i] = one.value;
    result.bound[i] = one.bound;
  }
  return result;
}

inline BoundedVector bounded_sum(const BoundedVector& a, const BoundedVector& b) {
  return bounded_by_component([&](int i) { return bounded_sum(a.component(i), b.component(i)); });
}

inline BoundedVector bounded_difference(const BoundedVector& a, const BoundedVector& b) {
  return bounded_by_component(
      [&](int i) { return bounded_difference(a.component(i), b.component(i)); });
}

inline BoundedVector bounded_product(const BoundedNumber& factor, const BoundedVector& a) {
  return bounded_by_component([&](int i) { return bounded_product(factor, a.component(i)); });
}

inline BoundedNumber bounded_dot(const BoundedVector& a, const BoundedVector& b) {
  BoundedNumber sum;
  for (int i = 0; i < 3; ++i) {
    sum = bounded_sum(sum, bounded_product(a.component(i), b.component(i)));
  }
  return sum;
}

}  // namespace kinestat
