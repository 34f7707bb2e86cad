#include "math/dense/readable_basis.hpp"

#include <cmath>

#include "core/tolerance.hpp"
#include "math/elimination/echelon.hpp"

namespace kinestat {

namespace {

// In the scales, the largest entry of each row 1.
MatX scaled_rows(const Eigen::Ref<const MatX>& rows, const VecX& scales) {
  MatX scaled = rows * scales.cwiseInverse().asDiagonal();
  for (Eigen::Index r = 0; r < scaled.rows(); ++r) {
    scaled.row(r) /= scaled.row(r).cwiseAbs().maxCoeff();
  }
  return scaled;
}

// Makes the rows zero in the pivot columns of those that were told; what is then left of a row that
// says nothing new is rounding.
void remove_reported(const Echelon& told, MatX& rows) {
  for (std::size_t j = 0; j < told.pivot_columns.size(); ++j) {
    const int column = told.pivot_columns[j];
    const VecX factors = rows.col(column);
    rows -= factors * told.matrix.row(static_cast<Eigen::Index>(j));
    rows.col(column).setZero();
  }
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    if (rows.row(r).cwiseAbs().maxCoeff() <= kRankZero) {
      rows.row(r).setZero();
    }
  }
}

}  // namespace

MatX readable_basis(const Eigen::Ref<const MatX>& rows,
                    const VecX& scales,
                    const Eigen::Ref<const MatX>& leading) {
  if (rows.rows() == 0 || rows.cols() == 0) {
    return MatX(0, scales.size());
  }
  MatX scaled = scaled_rows(rows, scales);
  if (leading.rows() > 0) {
    remove_reported(find_echelon(scaled_rows(leading, scales)), scaled);
  }
  const Echelon echelon = find_echelon(scaled);
  MatX basis(static_cast<Eigen::Index>(echelon.pivot_columns.size()), scales.size());
  for (Eigen::Index j = 0; j < basis.rows(); ++j) {
    const VecX row = echelon.matrix.row(j);
    const double zero = kRankZero * row.cwiseAbs().maxCoeff();
    const double first = scales[echelon.pivot_columns[static_cast<std::size_t>(j)]];
    for (Eigen::Index c = 0; c < row.size(); ++c) {
      basis(j, c) = std::abs(row[c]) > zero ? row[c] * scales[c] / first : 0.0;
    }
  }
  return basis;
}

MatX rows_of(std::span<const VecX> vectors, Eigen::Index columns) {
  MatX rows(static_cast<Eigen::Index>(vectors.size()), columns);
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    rows.row(static_cast<Eigen::Index>(j)) = vectors[j].transpose();
  }
  return rows;
}

}  // namespace kinestat
