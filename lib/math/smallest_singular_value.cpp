#include "math/smallest_singular_value.hpp"

#include <Eigen/SVD>

namespace kinestat {

double smallest_singular_value(const Eigen::Ref<const MatX>& matrix) {
  if (matrix.cols() == 0 || matrix.cols() > matrix.rows()) {
    return 0.0;
  }
  return Eigen::JacobiSVD<MatX>(matrix).singularValues().minCoeff();
}

}  // namespace kinestat
