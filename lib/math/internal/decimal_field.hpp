// Numbers of a hundred digits as a field for elimination.
#pragma once

#include "math/big_float.hpp"

namespace kinestat {

/// Not quite a field: what is below 10^-60 counts as zero, so that entries must be scaled to about
/// one. Forty digits are left for what elimination loses.
struct DecimalField {
  using Value = BigFloat;

  static bool is_zero(const BigFloat& a) {
    static const BigFloat least = pow(BigFloat(10), -60);
    return abs(a) <= least;
  }

  static BigFloat quotient(const BigFloat& a, const BigFloat& b) { return a / b; }

  static void add(BigFloat& a, const BigFloat& b) { a += b; }

  static void subtract_product(BigFloat& a, const BigFloat& b, const BigFloat& c) { a -= b * c; }
};

}  // namespace kinestat
