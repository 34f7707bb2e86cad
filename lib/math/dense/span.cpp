#include "math/dense/span.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/QR>

#include "core/tolerance.hpp"
#include "math/elimination/echelon.hpp"
#include "math/elimination/elimination.hpp"

namespace kinestat {

namespace {

// Zero columns stay.
MatX with_unit_columns(MatX A) {
  for (Eigen::Index c = 0; c < A.cols(); ++c) {
    const double size = A.col(c).norm();
    A.col(c) /= size > 0.0 ? size : 1.0;
  }
  return A;
}

}  // namespace

MatX null_space(const Eigen::Ref<const MatX>& A) {
  SparseMatrix sparse{
      .rows = static_cast<int>(A.rows()), .columns = static_cast<int>(A.cols()), .entries = {}};
  for (int r = 0; r < sparse.rows; ++r) {
    for (int c = 0; c < sparse.columns; ++c) {
      sparse.add(r, c, A(r, c));
    }
  }
  const std::vector<VecX> vectors = Elimination(std::move(sparse), {}).null_vectors();
  MatX basis(A.cols(), static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    basis.col(static_cast<Eigen::Index>(j)) = vectors[j];
  }
  return basis;
}

MatX intersect_spans(std::span<const MatX> spans, Eigen::Index size) {
  // x is in the span of Q if (I - Q Qᵀ) x = 0; the entries that are rounding would be taken for
  // equations.
  MatX equations(size * static_cast<Eigen::Index>(spans.size()), size);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const MatX Q = orthonormal_range(with_unit_columns(spans[i]));
    const MatX beside = MatX::Identity(size, size) - Q * Q.transpose();
    equations.middleRows(size * static_cast<Eigen::Index>(i), size) =
        (beside.array().abs() <= kRankZero).select(0.0, beside);
  }
  return null_space(equations);
}

std::vector<int> independent_columns(const Eigen::Ref<const MatX>& A) {
  return find_echelon(with_unit_columns(A)).pivot_columns;
}

std::vector<int> deciding_columns(MatX rows) {
  std::vector<int> columns;
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    const double size = rows.row(r).cwiseAbs().maxCoeff();
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      const double share = rows(r, columns[j]) / rows(chosen[j], columns[j]);
      if (share != 0.0) {
        rows.row(r) -= share * rows.row(chosen[j]);
        rows(r, columns[j]) = 0.0;
      }
    }
    Eigen::Index column = 0;
    if (rows.row(r).cwiseAbs().maxCoeff(&column) > kRankZero * size) {
      columns.push_back(static_cast<int>(column));
      chosen.push_back(r);
    }
  }
  return columns;
}

VecX coordinates_in(const Eigen::Ref<const MatX>& A, const VecX& b) {
  if (A.cols() == 0) {
    return {};
  }
  // Not by the normal equations: columns that are nearly parallel would depend on each other there.
  const Eigen::ColPivHouseholderQR<MatX> factors(with_unit_columns(A));
  return factors.solve(b).cwiseQuotient(A.colwise().norm().transpose());
}

MatX orthonormal_range(const Eigen::Ref<const MatX>& matrix) {
  MatX rest = matrix;
  MatX basis(matrix.rows(), std::min(matrix.rows(), matrix.cols()));
  Eigen::Index rank = 0;
  double first = 0.0;
  while (rank < basis.cols()) {
    Eigen::Index longest = 0;
    const double norm = rest.colwise().norm().maxCoeff(&longest);
    first = rank == 0 ? norm : first;
    if (norm <= kRankZero * first) {
      break;
    }
    basis.col(rank) = rest.col(longest) / norm;
    const VecX direction = basis.col(rank);
    for (int pass = 0; pass < 2; ++pass) {
      const VecX shares = rest.transpose() * direction;
      rest -= direction * shares.transpose();
    }
    ++rank;
  }
  return basis.leftCols(rank);
}

}  // namespace kinestat
