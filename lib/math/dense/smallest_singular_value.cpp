#include "math/dense/smallest_singular_value.hpp"

#include <algorithm>

#include <Eigen/SVD>

namespace kinestat {

double smallest_singular_value(const Eigen::Ref<const MatX>& matrix) {
  if (matrix.cols() == 0 || matrix.cols() > matrix.rows()) {
    return 0.0;
  }
  return Eigen::JacobiSVD<MatX>(matrix).singularValues().minCoeff();
}

double singular_value_share(const Eigen::Ref<const MatX>& matrix, int k) {
  const Eigen::Index count = std::min(matrix.rows(), matrix.cols());
  if (k > count) {
    return 0.0;
  }
  const VecX values = Eigen::JacobiSVD<MatX>(matrix).singularValues();
  return values[0] > 0.0 ? values[k - 1] / values[0] : 0.0;
}

}  // namespace kinestat
