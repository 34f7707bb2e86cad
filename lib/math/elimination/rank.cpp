#include "math/elimination/rank.hpp"

#include <cmath>
#include <limits>

#include <Eigen/QR>

#include "core/tolerance.hpp"
#include "math/elimination/equilibrate.hpp"

namespace kinestat {

namespace {

MatX equilibrated(const Eigen::Ref<const MatX>& matrix) {
  SparseMatrix sparse;
  sparse.rows = static_cast<int>(matrix.rows());
  sparse.columns = static_cast<int>(matrix.cols());
  for (int c = 0; c < sparse.columns; ++c) {
    for (int r = 0; r < sparse.rows; ++r) {
      sparse.add(r, c, matrix(r, c));
    }
  }
  const Scaling scaling = find_scaling(sparse);
  const Eigen::Map<const VecX> rows(scaling.rows.data(), matrix.rows());
  const Eigen::Map<const VecX> columns(scaling.columns.data(), matrix.cols());
  return rows.asDiagonal() * matrix * columns.asDiagonal();
}

}  // namespace

double RankEvidence::gap() const {
  if (largest_dropped == 0.0 || smallest_pivot == 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  return std::log10(smallest_pivot / largest_dropped);
}

RankEvidence find_rank(const Eigen::Ref<const MatX>& matrix) {
  RankEvidence evidence{
      .rank = 0, .smallest_pivot = 0.0, .largest_dropped = 0.0, .method = "column-pivoted QR"};
  if (matrix.size() == 0) {
    return evidence;
  }
  const Eigen::ColPivHouseholderQR<MatX> qr(equilibrated(matrix));
  const Eigen::Index count = std::min(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const double pivot = std::abs(qr.matrixQR()(i, i));
    if (pivot > kRankZero) {
      ++evidence.rank;
      evidence.smallest_pivot = pivot;
    } else {
      evidence.largest_dropped = std::max(evidence.largest_dropped, pivot);
    }
  }
  return evidence;
}

}  // namespace kinestat
