// Points of the plane with how far their coordinates may be off.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/rounding.hpp"
#include "math/numbers/bounded_arithmetic.hpp"
#include "studies/synthesis/positions/plane.hpp"

namespace kinestat {

/// x + iy, each with its own bound.
struct BoundedPoint {
  BoundedNumber x;
  BoundedNumber y;

  /// A point whose coordinates may be off by those of `bound`.
  static BoundedPoint within(const Point& value, const Point& bound) {
    return {.x = {.value = value.real(), .bound = bound.real()},
            .y = {.value = value.imag(), .bound = bound.imag()}};
  }

  /// A point that is as exact as coordinates are, which the formulas of a file have rounded.
  static BoundedPoint written(const Point& value) {
    const double bound = kDataRounding * std::max(std::abs(value.real()), std::abs(value.imag()));
    return within(value, {bound, bound});
  }

  Point value() const { return {x.value, y.value}; }

  Point bound() const { return {x.bound, y.bound}; }

  /// The coordinates that their bounds tell from zero; the others are zero.
  Point zeroed() const { return {x.zeroed(), y.zeroed()}; }
};

inline BoundedPoint operator+(const BoundedPoint& a, const BoundedPoint& b) {
  return {.x = bounded_sum(a.x, b.x), .y = bounded_sum(a.y, b.y)};
}

inline BoundedPoint operator-(const BoundedPoint& a, const BoundedPoint& b) {
  return {.x = bounded_difference(a.x, b.x), .y = bounded_difference(a.y, b.y)};
}

inline BoundedPoint operator*(const BoundedNumber& factor, const BoundedPoint& a) {
  return {.x = bounded_product(factor, a.x), .y = bounded_product(factor, a.y)};
}

inline BoundedPoint operator*(const BoundedPoint& a, const BoundedPoint& b) {
  return {.x = bounded_difference(bounded_product(a.x, b.x), bounded_product(a.y, b.y)),
          .y = bounded_sum(bounded_product(a.x, b.y), bounded_product(a.y, b.x))};
}

inline BoundedNumber dot(const BoundedPoint& a, const BoundedPoint& b) {
  return bounded_sum(bounded_product(a.x, b.x), bounded_product(a.y, b.y));
}

inline BoundedNumber cross(const BoundedPoint& a, const BoundedPoint& b) {
  return bounded_difference(bounded_product(a.x, b.y), bounded_product(a.y, b.x));
}

inline BoundedPoint conj(const BoundedPoint& a) {
  return {.x = a.x, .y = {.value = -a.y.value, .bound = a.y.bound}};
}

inline BoundedPoint operator/(const BoundedPoint& a, const BoundedPoint& b) {
  const BoundedNumber square = dot(b, b);
  const BoundedPoint product = a * conj(b);
  return {.x = product.x / square, .y = product.y / square};
}

/// Without error.
inline BoundedNumber exactly(double value) {
  return {.value = value, .bound = 0.0};
}

/// A number that is as exact as those of a file are.
inline BoundedNumber written(double value) {
  return {.value = value, .bound = kDataRounding * std::abs(value)};
}

/// The square root of a positive number: its relative error is at most that of the square.
inline BoundedNumber root(const BoundedNumber& square) {
  const double value = std::sqrt(square.value);
  return {.value = value, .bound = square.bound / value + kEpsilon * value};
}

/// The unit vector at an angle that is as exact as numbers of a file are.
inline BoundedPoint bounded_unit_vector(double angle) {
  const double bound = kDataRounding * std::max(1.0, std::abs(angle));
  return BoundedPoint::within(unit_vector(angle), {bound, bound});
}

}  // namespace kinestat
