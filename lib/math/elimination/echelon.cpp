#include "math/elimination/echelon.hpp"

#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Subtracts a multiple of the pivot row from row r; differences that are mere rounding become zero.
void subtract(MatX& rows, Eigen::Index r, Eigen::Index pivot, Eigen::Index column) {
  const double factor = rows(r, column);
  for (Eigen::Index c = 0; c < rows.cols(); ++c) {
    const double term = factor * rows(pivot, c);
    const double difference = rows(r, c) - term;
    const double size = std::abs(rows(r, c)) + std::abs(term);
    rows(r, c) = std::abs(difference) <= kCancellation * size ? 0.0 : difference;
  }
  rows(r, column) = 0.0;
}

}  // namespace

Echelon find_echelon(const Eigen::Ref<const MatX>& matrix) {
  Echelon result{.matrix = matrix, .pivot_columns = {}};
  MatX& rows = result.matrix;
  const double zero = kRankZero * (rows.size() == 0 ? 0.0 : rows.cwiseAbs().maxCoeff());
  Eigen::Index next = 0;
  for (Eigen::Index c = 0; c < rows.cols() && next < rows.rows(); ++c) {
    Eigen::Index pivot = 0;
    const double largest = rows.col(c).tail(rows.rows() - next).cwiseAbs().maxCoeff(&pivot);
    if (largest <= zero) {
      rows.col(c).tail(rows.rows() - next).setZero();
      continue;
    }
    rows.row(next).swap(rows.row(next + pivot));
    rows.row(next) /= rows(next, c);
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
      if (r != next && rows(r, c) != 0.0) {
        subtract(rows, r, next, c);
      }
    }
    result.pivot_columns.push_back(static_cast<int>(c));
    ++next;
  }
  return result;
}

}  // namespace kinestat
