// Points of the plane with more digits than a double has.
#pragma once

#include <type_traits>

#include "core/rounding.hpp"
#include "math/numbers/big_float.hpp"
#include "studies/synthesis/positions/plane.hpp"

namespace kinestat {

/// As Point; std::complex is for the built-in types of numbers alone.
class PrecisePoint {
 public:
  PrecisePoint() = default;

  PrecisePoint(BigFloat x, BigFloat y) : x_(std::move(x)), y_(std::move(y)) {}

  const BigFloat& real() const { return x_; }

  const BigFloat& imag() const { return y_; }

  friend PrecisePoint operator+(const PrecisePoint& a, const PrecisePoint& b) {
    return {a.x_ + b.x_, a.y_ + b.y_};
  }

  friend PrecisePoint operator-(const PrecisePoint& a, const PrecisePoint& b) {
    return {a.x_ - b.x_, a.y_ - b.y_};
  }

  friend PrecisePoint operator*(const PrecisePoint& a, const PrecisePoint& b) {
    return {a.x_ * b.x_ - a.y_ * b.y_, a.x_ * b.y_ + a.y_ * b.x_};
  }

  friend PrecisePoint operator*(const BigFloat& factor, const PrecisePoint& a) {
    return {factor * a.x_, factor * a.y_};
  }

  friend PrecisePoint operator/(const PrecisePoint& a, const BigFloat& divisor) {
    return {a.x_ / divisor, a.y_ / divisor};
  }

  friend BigFloat abs(const PrecisePoint& a) { return sqrt(a.x_ * a.x_ + a.y_ * a.y_); }

  friend BigFloat dot(const PrecisePoint& a, const PrecisePoint& b) {
    return a.x_ * b.x_ + a.y_ * b.y_;
  }

  friend BigFloat cross(const PrecisePoint& a, const PrecisePoint& b) {
    return a.x_ * b.y_ - a.y_ * b.x_;
  }

  friend PrecisePoint left_of(const PrecisePoint& a) { return {-a.y_, a.x_}; }

 private:
  BigFloat x_{0};
  BigFloat y_{0};
};

/// What rounding may leave of a sum that is zero, as a share of the sizes of its terms.
template <class Scalar>
Scalar sum_rounding() {
  if constexpr (std::is_same_v<Scalar, double>) {
    return kDataRounding;
  } else {
    return big_float_rounding();
  }
}

/// The points that go with a type of number.
template <class Scalar>
using PointOf = std::conditional_t<std::is_same_v<Scalar, double>, Point, PrecisePoint>;

}  // namespace kinestat
