// Solutions with a matrix that was eliminated in a hundred digits.
#pragma once

#include <vector>

#include "math/elimination/equilibrate.hpp"
#include "math/elimination/exact_input_elimination.hpp"
#include "math/elimination/internal/field_elimination.hpp"
#include "math/numbers/big_float.hpp"

namespace kinestat {

/// Numbers of a hundred digits as a field for elimination. Not quite a field: what is below 10^-60
/// counts as zero, so that entries must be scaled to about one. Forty digits are left for what
/// elimination loses.
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

/// An entry of the scaled matrix.
struct DecimalEntry {
  int row = 0;
  int column = 0;
  BigFloat value;
};

struct DecimalFactors {
  Scaling scaling;
  std::vector<DecimalEntry> entries;
  FieldElimination<DecimalField> decimals;
};

/// `x` holds the known unknowns, scaled, and zero elsewhere; `rhs` the scaled right-hand side. Each
/// sum carries the sizes of its terms: what is below the rounding of the field among them is made
/// zero where it is summed, and has that rounding as its bound.
ExactInputSolution solve_decimals(const DecimalFactors& factors,
                                  std::vector<BigFloat> x,
                                  const std::vector<BigFloat>& rhs);

}  // namespace kinestat
