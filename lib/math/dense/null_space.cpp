#include "math/dense/null_space.hpp"

#include <Eigen/SVD>

#include "core/contract.hpp"

namespace kinestat {

double NullSpace::reciprocal_condition() const {
  const Eigen::Index last = singular_values.size() - 1;
  return last < 0 || singular_values[0] == 0.0 ? 0.0 : singular_values[last] / singular_values[0];
}

NullSpace find_null_space(const Eigen::Ref<const MatX>& matrix) {
  KINESTAT_EXPECTS(matrix.rows() <= matrix.cols());
  const Eigen::Index rows = matrix.rows();
  if (rows == 0) {
    const MatX all = MatX::Identity(matrix.cols(), matrix.cols());
    return {.basis = all, .singular_values = VecX(0), .inverse = MatX(matrix.cols(), 0)};
  }
  const Eigen::JacobiSVD<MatX> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  NullSpace result;
  result.singular_values = svd.singularValues();
  result.basis = svd.matrixV().rightCols(matrix.cols() - rows);
  const VecX reciprocal = result.singular_values.cwiseInverse();
  result.inverse = svd.matrixV().leftCols(rows) * reciprocal.asDiagonal();
  result.inverse = (result.inverse * svd.matrixU().transpose()).eval();
  return result;
}

}  // namespace kinestat
