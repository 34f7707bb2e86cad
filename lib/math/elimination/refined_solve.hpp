// The solution of a sparse system beyond the digits of a double, with a bound on its error.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/types.hpp"
#include "math/elimination/elimination.hpp"
#include "math/numbers/double_double.hpp"

namespace kinestat {

/// Solves A x = b with some of x known, as Elimination::solve does, then as often as asked for x +=
/// (LU)⁻¹ (b - A x) with a residual of twice the digits (Wilkinson 1963). Each step multiplies the
/// error by about the condition number times 1e-16, down to 1e-32 of x. Meant are the equations
/// that hold a pivot: whether the surplus ones hold too is for Elimination to say.
class RefinedSolve {
 public:
  /// The solution in double. `factors` must outlive this; arguments as of Elimination::solve.
  RefinedSolve(const Elimination& factors,
               std::span<const double> known,
               std::span<const double> rhs);

  /// One step of refinement.
  void refine();

  /// One a column of A: known as given, free 0.
  std::vector<DoubleDouble> x() const;

  /// How far each x may be from the exact solution for these very doubles, one a column of A; found
  /// without it. What is left after the next correction d, which is known, is bounded by |d| +
  /// |A⁻¹| |b - A (x + d)|, and |A⁻¹| by triangular majorants: the factors with their signs turned
  /// so that nothing cancels, and with what rounding did to them (numerics: Rump, Acta Numerica 19,
  /// 2010, section 10; majorants: Higham, Accuracy and Stability, section 8.3). So the majorants,
  /// which may be far too large, only count in the second order. Empty if A may be singular for all
  /// that the factors tell, or if numbers overflow. A bound proves that the pivots of the factors
  /// are those of a regular part of A: its rank is at least their number.
  std::optional<VecX> error_bound() const;

 private:
  // An entry of A in scaled units, in a row that holds a pivot.
  struct Entry {
    int row = 0;
    int column = 0;
    double value = 0.0;
  };

  // A sum of many terms: sum + rest + tail, give or take slack · 2^-53.
  struct Accumulator {
    double sum = 0.0;
    double rest = 0.0;
    double tail = 0.0;
    double slack = 0.0;

    void subtract_product(double a, double b);
  };

  void load_entries();
  void start_residual();
  void subtract_from_residual(const VecX& x);
  void find_correction();
  VecX solve(VecX right) const;
  VecX majorant(VecX right) const;
  VecX left_over() const;
  VecX rounding_of_factors(const VecX& x) const;
  std::optional<VecX> bound_by_factors(const VecX& left) const;
  std::optional<VecX> bound_by_inverse(const VecX& left) const;

  const Elimination& factors_;
  std::vector<Entry> entries_;
  std::vector<double> rounding_;  ///< of the factors, a row: share of |L| |U| by which L U is not A
  std::vector<double> right_;     ///< of the equations, scaled; empty for zero
  std::vector<Accumulator> residual_;  ///< b - A x, one an equation
  VecX high_;                          ///< x = high + low, scaled
  VecX low_;
  VecX correction_;  ///< d
};

}  // namespace kinestat
