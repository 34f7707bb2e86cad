#include "math/dense/orthonormal.hpp"

#include <algorithm>

#include "core/tolerance.hpp"

namespace kinestat {

MatX orthonormal_range(const Eigen::Ref<const MatX>& matrix) {
  MatX rest = matrix;
  MatX basis(matrix.rows(), std::min(matrix.rows(), matrix.cols()));
  Eigen::Index rank = 0;
  double first = 0.0;
  while (rank < basis.cols()) {
    Eigen::Index longest = 0;
    const double norm = rest.colwise().norm().maxCoeff(&longest);
    first = rank == 0 ? norm : first;
    if (norm <= kRankZero * first) {
      break;
    }
    basis.col(rank) = rest.col(longest) / norm;
    const VecX direction = basis.col(rank);
    for (int pass = 0; pass < 2; ++pass) {
      const VecX shares = rest.transpose() * direction;
      rest -= direction * shares.transpose();
    }
    ++rank;
  }
  return basis.leftCols(rank);
}

}  // namespace kinestat
