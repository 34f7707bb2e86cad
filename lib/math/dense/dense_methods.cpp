#include "math/dense/dense_methods.hpp"

#include <algorithm>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/contract.hpp"

namespace kinestat {

namespace {

template <class Number>
std::vector<DoubleDouble> two_doubles_of(const Eigen::Matrix<Number, Eigen::Dynamic, 1>& x) {
  std::vector<DoubleDouble> result;
  result.reserve(static_cast<std::size_t>(x.size()));
  for (const Number value : x) {
    const auto high = static_cast<double>(value);
    result.push_back({.high = high, .low = static_cast<double>(value - static_cast<Number>(high))});
  }
  return result;
}

template <class Number>
std::vector<DoubleDouble> solve_by_elimination(const MatX& A, const VecX& b) {
  using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
  const Vector x = Eigen::PartialPivLU<Matrix>(A.cast<Number>()).solve(b.cast<Number>());
  return two_doubles_of<Number>(x);
}

}  // namespace

std::vector<DoubleDouble> solve_by(DenseMethod method, const MatX& A, const VecX& b) {
  KINESTAT_EXPECTS(A.rows() == A.cols() && A.rows() == b.size());
  switch (method) {
    case DenseMethod::float_lu:
      return solve_by_elimination<float>(A, b);
    case DenseMethod::double_lu:
      return solve_by_elimination<double>(A, b);
    case DenseMethod::long_double_lu:
      return solve_by_elimination<long double>(A, b);
    case DenseMethod::singular_values:
      break;
  }
  const VecX x = Eigen::JacobiSVD<MatX>(A, Eigen::ComputeThinU | Eigen::ComputeThinV).solve(b);
  return two_doubles_of<double>(x);
}

std::vector<int> independent_rows(const MatX& A) {
  KINESTAT_EXPECTS(A.rows() >= A.cols());
  const Eigen::ColPivHouseholderQR<MatX> factors(A.transpose());
  const auto& order = factors.colsPermutation().indices();
  std::vector<int> rows(order.data(), order.data() + A.cols());
  std::ranges::sort(rows);
  return rows;
}

}  // namespace kinestat
