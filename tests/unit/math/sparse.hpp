// Sparse matrices from dense ones.
#pragma once

#include "core/types.hpp"
#include "math/elimination/sparse_matrix.hpp"

namespace kinestat {

inline SparseMatrix sparse(const MatX& dense) {
  SparseMatrix matrix{.rows = static_cast<int>(dense.rows()),
                      .columns = static_cast<int>(dense.cols()),
                      .entries = {}};
  for (int r = 0; r < matrix.rows; ++r) {
    for (int c = 0; c < matrix.columns; ++c) {
      matrix.add(r, c, dense(r, c));
    }
  }
  return matrix;
}

}  // namespace kinestat
