// A square sparse system solved by KLU: the unit of the benchmark of large networks.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/sparse_matrix.hpp"

namespace kinestat::bench {

/// A x = b for the columns of a system whose x is not known; entries at the same place added up.
class KluSolve {
 public:
  /// Throws std::runtime_error unless as many columns are left as there are rows.
  KluSolve(const SparseMatrix& matrix, std::span<const int> known, std::span<const double> values);

  /// Analysed, factored and solved anew. Throws std::runtime_error if KLU refuses.
  void solve();

  /// The largest difference to the unknowns among `x`, relative to the largest of them.
  double difference(const VecX& x) const;

 private:
  std::vector<int> columns_;  // of the matrix, of those that are left
  std::vector<int> starts_;   // compressed columns
  std::vector<int> rows_;
  std::vector<double> values_;
  std::vector<double> right_;
  std::vector<double> x_;
};

}  // namespace kinestat::bench
