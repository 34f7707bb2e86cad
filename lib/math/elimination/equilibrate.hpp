// Scaling of rows and columns by powers of two, so that sizes do not depend on units.
#pragma once

#include "math/elimination/sparse_matrix.hpp"

namespace kinestat {

/// The scaled matrix is diag(rows) · A · diag(columns); powers of two, so that nothing is rounded.
struct Scaling {
  std::vector<double> rows;
  std::vector<double> columns;
};

/// Brings the largest entry of every row and column to between 1/2 and 1 as far as both can be had.
/// Zero rows and columns keep the factor 1.
Scaling find_scaling(const SparseMatrix& matrix);

}  // namespace kinestat
