// The solution of a sparse system to as many digits as asked for, with a bound on its error.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/accuracy.hpp"
#include "math/elimination/elimination.hpp"

namespace kinestat {

struct BoundedSolution {
  EliminationSolution solution;
  Precision precision = Precision::plain;
  std::optional<VecX> bound;  ///< of each x, against the solution for these very doubles; empty:
                              ///< none was asked for, or the matrix may be singular
};

/// Solves as Elimination::solve does and then goes on as the request says: not at all (fast), until
/// the bound of every column that `counts` promises the digits (automatic), or until it promises
/// those of a double (high, exact). The residual stays that of the elimination.
BoundedSolution solve_to_digits(const Elimination& elimination,
                                std::span<const double> known,
                                std::span<const double> rhs,
                                const AccuracyRequest& request,
                                const std::vector<bool>& counts);

/// The largest of the sizes, 0 if there is none.
double largest_size(std::span<const double> numbers);

/// The largest error of the values that `counts`, relative to each: 1 where not one digit is sure.
/// A value that its bound does not tell from zero is written as zero, and right, as long as its
/// bound is mere rounding of the largest value, or of the largest of the right-hand side, which it
/// may be a sum of.
double worst_relative_error(const VecX& values,
                            const VecX& bounds,
                            const std::vector<bool>& counts,
                            double largest_right);

}  // namespace kinestat
