#include "math/dense/dense_solve.hpp"

#include <Eigen/LU>

namespace kinestat {

std::optional<VecX> solve_dense(const MatX& A, const VecX& b) {
  if (A.cols() == 0) {
    return VecX(0);
  }
  const Eigen::FullPivLU<MatX> factors(A);
  const VecX x = factors.solve(b);
  return factors.isInvertible() && x.allFinite() ? std::optional(x) : std::nullopt;
}

}  // namespace kinestat
