// A number with how far it may be off, which arithmetic passes on.
#pragma once

#include "core/types.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

/// The true number lies within `bound` of `value`. The bound of a result contains its own rounding;
/// one that is not finite promises nothing.
struct BoundedNumber {
  double value = 0.0;
  double bound = 0.0;  ///< never negative

  /// Error relative to the value; at most 1: then not one digit is sure. A zero without error has
  /// 0.
  double relative_bound() const;

  /// The value, or zero where its bound does not tell it from zero.
  double zeroed() const { return zero_within_bound(value, bound); }
};

BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b);
BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b);
BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b);

/// Without a finite bound where the divisor may be zero.
BoundedNumber operator/(const BoundedNumber& a, const BoundedNumber& b);

/// Each component of the true vector lies within that of `bound` of that of `value`.
struct BoundedVector {
  Vec3 value = Vec3::Zero();
  Vec3 bound = Vec3::Zero();  ///< never negative

  BoundedNumber component(int i) const { return {.value = value[i], .bound = bound[i]}; }

  /// The components that their bounds tell from zero; the others are zero.
  Vec3 zeroed() const;
};

/// A vector each of whose components may be off by that share of the largest one.
BoundedVector rounded_vector(const Vec3& value, double share);

BoundedVector operator+(const BoundedVector& a, const BoundedVector& b);
BoundedVector operator-(const BoundedVector& a, const BoundedVector& b);
BoundedVector operator*(const BoundedNumber& factor, const BoundedVector& a);
BoundedVector cross(const BoundedVector& a, const BoundedVector& b);
BoundedNumber dot(const BoundedVector& a, const BoundedVector& b);

}  // namespace kinestat
