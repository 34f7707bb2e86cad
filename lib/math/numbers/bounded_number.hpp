// A number with how far it may be off, which arithmetic passes on.
#pragma once

#include "math/numbers/settled.hpp"

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
  double zeroed() const { return settled(value, bound); }
};

BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b);
BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b);
BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b);

/// Without a finite bound where the divisor may be zero.
BoundedNumber operator/(const BoundedNumber& a, const BoundedNumber& b);

}  // namespace kinestat
