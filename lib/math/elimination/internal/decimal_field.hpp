// Numbers of a hundred digits as a field for elimination.
#pragma once

#include "math/numbers/big_float.hpp"

namespace kinestat {

/// Not quite a field: what is below 10^-60 counts as zero, so that entries must be scaled to about
/// one. Forty digits are left for what elimination loses.
struct DecimalField {
  using Value = BigFloat;

  static bool is_zero(const BigFloat& a) { return is_zero_among(a, BigFloat(1)); }

  /// Of a sum of terms whose sizes sum to `size`.
  static bool is_zero_among(const BigFloat& a, const BigFloat& size) {
    return abs(a) <= rounding() * size;
  }

  /// What counts as zero, as share of the terms that it is a sum of.
  static const BigFloat& rounding() {
    static const BigFloat share = pow(BigFloat(10), -60);
    return share;
  }

  static BigFloat quotient(const BigFloat& a, const BigFloat& b) { return a / b; }

  static void add(BigFloat& a, const BigFloat& b) { a += b; }

  static void subtract_product(BigFloat& a, const BigFloat& b, const BigFloat& c) { a -= b * c; }
};

}  // namespace kinestat
