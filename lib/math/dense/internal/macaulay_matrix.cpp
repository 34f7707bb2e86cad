#include "math/dense/internal/macaulay_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/synthesis_tolerance.hpp"

namespace kinestat {

namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector3cd;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Mat64 = Eigen::Matrix<double, 6, 4>;
using Mat104 = Eigen::Matrix<double, 10, 4>;

// Quadratic monomials xx xy xz yy yz zz, as pairs of variables.
constexpr std::array<std::array<int, 2>, 6> kPairs = {
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

// Index of the cubic monomial x^i y^j z^k, for the powers i and j.
constexpr int kCubic[4][4] = {{0, 1, 2, 3}, {4, 5, 6, -1}, {7, 8, -1, -1}, {9, -1, -1, -1}};

// Index of quadratic monomial times variable.
constexpr int product(std::size_t pair, int variable) {
  int powers[3] = {0, 0, 0};
  ++powers[kPairs[pair][0]];
  ++powers[kPairs[pair][1]];
  ++powers[variable];
  return kCubic[powers[0]][powers[1]];
}

// A fixed rotation, so that no coordinate axis of the caller is special.
Mat3 generic_axes() {
  const Eigen::Quaterniond turn(0.6533, 0.2706, -0.4619, 0.5345);
  return turn.normalized().toRotationMatrix();
}

// What multiplication by a linear form makes of the null space.
Mat64 times_form(const Mat104& cubics, const Vec3& form) {
  Mat64 result = Mat64::Zero();
  for (std::size_t pair = 0; pair < kPairs.size(); ++pair) {
    for (int variable = 0; variable < 3; ++variable) {
      result.row(static_cast<Eigen::Index>(pair)) +=
          form[variable] * cubics.row(product(pair, variable));
    }
  }
  return result;
}

// The point whose cubic monomials these are: their 6 x 3 table is (quadratic monomials) yᵀ.
Point point_of_monomials(const Eigen::Matrix<Complex, 10, 1>& cubic) {
  Eigen::Matrix<Complex, 6, 3> table;
  for (std::size_t pair = 0; pair < kPairs.size(); ++pair) {
    for (int variable = 0; variable < 3; ++variable) {
      table(static_cast<Eigen::Index>(pair), variable) = cubic[product(pair, variable)];
    }
  }
  Eigen::Index largest = 0;
  table.rowwise().squaredNorm().maxCoeff(&largest);
  return table.row(largest).transpose().normalized();
}

std::vector<Point> eigen_points(const Mat104& cubics, const Mat4& multiplication) {
  const Eigen::EigenSolver<Mat4> solver(multiplication);
  std::vector<Point> points;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Eigen::Vector4cd vector = solver.eigenvectors().col(i);
    points.push_back(point_of_monomials(cubics.cast<Complex>() * vector));
  }
  return points;
}

}  // namespace

double conic_miss(const Mat3& a, const Mat3& b, const Point& y) {
  return std::abs((y.transpose() * a * y).value()) + std::abs((y.transpose() * b * y).value());
}

MacaulayMatrix::MacaulayMatrix(const Mat3& a, const Mat3& b) : a_(a), b_(b) {
  Eigen::Matrix<double, 6, 10> multiples = Eigen::Matrix<double, 6, 10>::Zero();
  for (int variable = 0; variable < 3; ++variable) {
    for (std::size_t pair = 0; pair < kPairs.size(); ++pair) {
      const auto [i, j] = kPairs[pair];
      const double twice = i == j ? 1.0 : 2.0;
      multiples(variable, product(pair, variable)) = twice * a(i, j);
      multiples(variable + 3, product(pair, variable)) = twice * b(i, j);
    }
  }
  const Eigen::JacobiSVD<Eigen::Matrix<double, 6, 10>> svd(multiples, Eigen::ComputeFullV);
  gap_ = svd.singularValues()[5] / svd.singularValues()[0];
  cubics_ = svd.matrixV().rightCols<4>();
}

// Of several forms the one whose multiplication is easiest to undo; the other forms are tried as
// numerators until all points lie on the conics.
std::vector<Point> MacaulayMatrix::rough_points() const {
  const Mat3 axes = generic_axes();
  std::array<Mat64, 3> products;
  int best = 0;
  double largest = -1.0;
  for (int i = 0; i < 3; ++i) {
    products[static_cast<std::size_t>(i)] = times_form(cubics_, axes.col(i));
    const Eigen::ColPivHouseholderQR<Mat64> qr(products[static_cast<std::size_t>(i)]);
    const double pivot = std::abs(qr.matrixR()(3, 3));
    best = pivot > largest ? i : best;
    largest = std::max(pivot, largest);
  }
  const Eigen::ColPivHouseholderQR<Mat64> denominator(products[static_cast<std::size_t>(best)]);
  std::vector<Point> points;
  double worst = std::numeric_limits<double>::infinity();
  const Mat64& first = products[static_cast<std::size_t>((best + 1) % 3)];
  const Mat64& second = products[static_cast<std::size_t>((best + 2) % 3)];
  for (const double mixing : {0.6180339887, -1.7320508076, 0.3141592654}) {
    std::vector<Point> found = eigen_points(cubics_, denominator.solve(first + mixing * second));
    const double miss = worst_miss(found);
    if (miss < worst) {
      worst = miss;
      points = std::move(found);
    }
    if (worst < kRoughPoint) {
      break;
    }
  }
  return points;
}

double MacaulayMatrix::worst_miss(const std::vector<Point>& points) const {
  double worst = 0.0;
  for (const Point& y : points) {
    worst = std::max(worst, conic_miss(a_, b_, y));
  }
  return worst;
}

}  // namespace kinestat
