#include "math/dense/normal_equations.hpp"

#include <Eigen/QR>

#include "core/contract.hpp"

namespace kinestat {

NormalEquations::NormalEquations(const MatX& A) {
  KINESTAT_EXPECTS(A.rows() >= A.cols());
  const Eigen::HouseholderQR<MatX> factors(A);
  R_ = factors.matrixQR().topRows(A.cols());
}

VecX NormalEquations::solve(VecX b) const {
  KINESTAT_EXPECTS(b.size() == R_.rows());
  R_.triangularView<Eigen::Upper>().transpose().solveInPlace(b);
  R_.triangularView<Eigen::Upper>().solveInPlace(b);
  return b;
}

}  // namespace kinestat
