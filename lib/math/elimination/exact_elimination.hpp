// Gaussian elimination of a sparse system of fractions: nothing is rounded, so nothing is decided.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "math/elimination/sparse_matrix.hpp"
#include "math/numbers/rational.hpp"

namespace kinestat {

struct ExactEntry {
  int row = 0;
  int column = 0;
  Rational value;
};

/// Entries in any order; entries at the same place add up.
struct ExactMatrix {
  int rows = 0;
  int columns = 0;
  std::vector<ExactEntry> entries;
};

/// The matrix of these very doubles, which must be finite.
ExactMatrix exact_matrix(const SparseMatrix& matrix);

/// Solution of A x = b with some of x known.
struct ExactSolution {
  std::vector<Rational> x;  ///< free columns are 0; meaningless unless consistent
  bool consistent = true;   ///< the surplus equations hold
};

/// The questions of Elimination, without rounding: the rank is that of the matrix as it is,
/// whatever its scales, proved by the elimination itself. Numbers grow, by how much depends on the
/// matrix; those of mechanisms are sparse, and theirs grow little. Pivots are chosen for sparsity
/// alone.
class ExactElimination {
 public:
  /// `last` holds the columns whose x is to be known; it may be empty.
  ExactElimination(const ExactMatrix& matrix, std::span<const int> last);
  ~ExactElimination();
  ExactElimination(ExactElimination&& other) noexcept;
  ExactElimination& operator=(ExactElimination&& other) noexcept;
  ExactElimination(const ExactElimination&) = delete;
  ExactElimination& operator=(const ExactElimination&) = delete;

  int rank() const;

  /// Columns outside `last` that no equation determines, ascending. Their number is that of
  /// Elimination; which of several are free may differ.
  const std::vector<int>& free_columns() const;

  /// How many independent relations the equations ask of the columns of `last`.
  int relation_count() const;

  /// Solves for the columns outside `last`, given x at the columns of `last` (in that order) and
  /// the right-hand side (empty: zero).
  ExactSolution solve(std::span<const Rational> known, std::span<const Rational> rhs) const;

  /// A basis of the solutions of A x = 0 with x = 0 at `last`: one vector a free column, 1 there
  /// and 0 at the other free columns.
  std::vector<std::vector<Rational>> null_vectors() const;

 private:
  struct Factors;

  std::unique_ptr<Factors> factors_;
};

}  // namespace kinestat
