#include "math/dense/least_norm.hpp"

#include <Eigen/QR>

namespace kinestat {

VecX least_norm_solution(const MatX& A, const VecX& b) {
  return Eigen::CompleteOrthogonalDecomposition<MatX>(A).solve(b);
}

}  // namespace kinestat
