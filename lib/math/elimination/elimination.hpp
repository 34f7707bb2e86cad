// Gaussian elimination of a sparse system, with the rank decision taken on the way.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/equilibrate.hpp"
#include "math/elimination/rank.hpp"

namespace kinestat {

/// A linear relation that the known unknowns must satisfy because the equations say so:
/// sum of coefficient · x[column] = constant.
struct Relation {
  std::vector<SparseEntry> terms;  ///< row unused; value = coefficient in the units of the matrix
  std::vector<int> equations;      ///< rows of the matrix that combine to the relation, ascending
  double constant = 0.0;           ///< from the right-hand side; what is mere rounding of it is 0
  double constant_size = 0.0;      ///< sum of the sizes of what was summed into the constant
};

/// Solution of A x = b with some of x known.
struct EliminationSolution {
  VecX x;                  ///< free columns are 0
  double residual = 0.0;   ///< largest |A x - b| relative to the largest sum of terms, scaled rows
  bool consistent = true;  ///< the surplus equations hold within kConsistency of their terms
};

/// How g·x moves, x being a solution of A x = b with some of x known: by known · δx[last] +
/// rows · (δb - δA x), for any small changes that keep the equations consistent.
struct AdjointSolution {
  VecX rows;   ///< one an equation
  VecX known;  ///< one a column of `last`, in that order
};

/// Factors A once; solves for any right-hand side. Columns are pivoted in the order of their
/// counts, rows by length among those with a sufficient entry (threshold Markowitz), after scaling
/// by powers of two. The columns named last are pivoted after all others: what is then left in
/// their rows are relations between them. So one elimination answers: the rank, whether a choice of
/// known unknowns is independent and sufficient, and the solution.
class Elimination {
 public:
  /// `last` holds the columns whose x is to be known; it may be empty.
  Elimination(SparseMatrix matrix, std::span<const int> last);

  int rank() const { return evidence_.rank; }

  const SparseMatrix& matrix() const { return matrix_; }

  const RankEvidence& evidence() const { return evidence_; }

  /// Columns outside `last` that no equation determines, ascending.
  const std::vector<int>& free_columns() const { return free_columns_; }

  /// One relation a pivot among the `last` columns; empty means that they are independent. The
  /// right-hand side may be empty: zero.
  std::vector<Relation> relations(std::span<const double> rhs = {}) const;

  /// Solves for the columns outside `last`, given x at the columns of `last` (in that order) and
  /// the right-hand side (empty: zero).
  EliminationSolution solve(std::span<const double> known, std::span<const double> rhs) const;

  /// Solves Aᵀ y = g for the columns outside `last`; what is left of g at `last` is their part. g
  /// must be zero at the free columns.
  AdjointSolution solve_adjoint(const VecX& gradient) const;

  /// No less than the largest changes of x outside `last` if each right-hand side changes by up to
  /// so much: by the sizes in the factors, so perhaps far more than that, at the cost of a solve.
  VecX most_change(const VecX& errors) const;

  /// Whether the surplus equations hold for these known x and this right-hand side, as solve finds
  /// it.
  bool is_consistent(std::span<const double> known, std::span<const double> rhs) const;

  /// The largest |A x - b| relative to the largest sum of terms, in scaled rows.
  double residual(const VecX& x, std::span<const double> rhs) const;

  /// The equations that determine columns outside `last`, ascending; all others are surplus.
  std::vector<int> pivot_rows() const;

  /// A basis of the solutions of A x = 0 with x = 0 at `last`: one vector a free column, 1 there.
  std::vector<VecX> null_vectors() const;

  /// Their sum with weights drawn at random, so that it is zero only where all of them are: for
  /// networks in which all of them would fill the memory. Always the same.
  VecX mixed_null_vector() const;

 private:
  friend class Eliminator;
  friend class RefinedSolve;

  struct Cell {
    int column = 0;
    double value = 0.0;
  };

  struct Multiplier {
    int row = 0;
    int pivot_row = 0;
    double value = 0.0;
  };

  struct Pivot {
    int row = 0;
    int column = 0;
    double value = 0.0;
  };

  // A right-hand side after the steps of the elimination, and how much was summed into each row.
  struct EliminatedRows {
    std::vector<double> values;
    std::vector<double> sizes;
  };

  void back_substitute(std::span<const double> scaled_rhs, VecX& x) const;
  bool surplus_rows_hold(const VecX& scaled_x, const EliminatedRows& right) const;
  VecX combined_rows(VecX eliminated) const;
  std::vector<int> equations_of(const Pivot& pivot) const;
  VecX scaled_known(std::span<const double> known) const;
  EliminatedRows eliminate_rows(std::span<const double> rhs) const;
  void unscale(VecX& x) const;

  SparseMatrix matrix_;
  Scaling scaling_;
  std::vector<int> last_;
  std::vector<std::vector<Cell>> rows_;  ///< what is left of each row, pivots included
  std::vector<Multiplier> multipliers_;  ///< in the order of their application
  std::vector<Pivot> pivots_;            ///< of the columns outside last_
  std::vector<Pivot> last_pivots_;       ///< of the columns of last_
  std::vector<int> free_columns_;
  RankEvidence evidence_;
  bool has_dropped_ = false;  ///< a difference that was rounding and not zero was made zero
};

}  // namespace kinestat
