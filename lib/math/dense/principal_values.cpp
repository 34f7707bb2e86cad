#include "math/dense/principal_values.hpp"

#include <Eigen/Eigenvalues>

namespace kinestat {

Vec3 principal_values(const Eigen::Matrix3d& tensor) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace kinestat
