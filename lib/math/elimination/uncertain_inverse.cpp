#include "math/elimination/uncertain_inverse.hpp"

#include <Eigen/QR>

#include "core/tolerance.hpp"

namespace kinestat {

UncertainInverse find_uncertain_inverse(const MatX& matrix, double error) {
  UncertainInverse result;
  const double largest = matrix.size() == 0 ? 0.0 : matrix.cwiseAbs().maxCoeff();
  if (largest <= 0.0) {
    return result;
  }
  Eigen::ColPivHouseholderQR<MatX> qr(matrix);
  qr.setThreshold(error / largest + kEpsilon);
  result.rank = static_cast<int>(qr.rank());
  if (matrix.rows() == matrix.cols() && result.rank == matrix.rows()) {
    result.inverse = qr.inverse();
  }
  return result;
}

}  // namespace kinestat
