// Solutions with a matrix that was eliminated in a hundred digits.
#pragma once

#include <vector>

#include "math/elimination/equilibrate.hpp"
#include "math/elimination/exact_input_elimination.hpp"
#include "math/elimination/internal/decimal_field.hpp"
#include "math/elimination/internal/field_elimination.hpp"

namespace kinestat {

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
