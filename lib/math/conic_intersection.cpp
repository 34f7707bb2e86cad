#include "math/conic_intersection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector3cd;
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

Mat104 find_cubics(const Mat3& a, const Mat3& b, double& gap) {
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
  gap = svd.singularValues()[5] / svd.singularValues()[0];
  return svd.matrixV().rightCols<4>();
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

// Makes the largest coordinate real and positive.
Point in_phase(const Point& y) {
  Eigen::Index largest = 0;
  y.cwiseAbs().maxCoeff(&largest);
  return y * (std::conj(y[largest]) / std::abs(y[largest]));
}

class Intersection {
 public:
  Intersection(const Mat3& a, const Mat3& b) : a_(a / a.norm()), b_(b / b.norm()) {
    // The same pencil, spanned by two conics that are as different as can be.
    b_ -= a_ * a_.cwiseProduct(b_).sum();
    const double rest = b_.norm();
    is_one_conic_ = !(rest > kSharedComponent);
    b_ /= is_one_conic_ ? 1.0 : rest;
  }

  ConicIntersection run() {
    ConicIntersection result;
    if (is_one_conic_) {
      result.shared = SharedPart::conic;
      return result;
    }
    const Mat104 cubics = find_cubics(a_, b_, result.gap);
    if (result.gap < kSharedComponent) {
      result.shared = SharedPart::line;
      take_out_line(result);
      return result;
    }
    result.points = merged(find_points(cubics));
    return result;
  }

 private:
  double residual(const Point& y) const {
    return std::abs((y.transpose() * a_ * y).value()) + std::abs((y.transpose() * b_ * y).value());
  }

  // Of several forms the one whose multiplication is easiest to undo; the other forms are tried as
  // numerators until all points lie on the conics.
  std::vector<Point> find_points(const Mat104& cubics) const {
    const Mat3 axes = generic_axes();
    std::array<Mat64, 3> products;
    int best = 0;
    double largest = -1.0;
    for (int i = 0; i < 3; ++i) {
      products[static_cast<std::size_t>(i)] = times_form(cubics, axes.col(i));
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
      std::vector<Point> found = eigen_points(cubics, denominator.solve(first + mixing * second));
      const double miss = worst_residual(found);
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

  double worst_residual(const std::vector<Point>& points) const {
    double worst = 0.0;
    for (const Point& y : points) {
      worst = std::max(worst, residual(y));
    }
    return worst;
  }

  static std::vector<Point> eigen_points(const Mat104& cubics, const Mat4& multiplication) {
    const Eigen::EigenSolver<Mat4> solver(multiplication);
    std::vector<Point> points;
    for (Eigen::Index i = 0; i < 4; ++i) {
      const Eigen::Vector4cd vector = solver.eigenvectors().col(i);
      points.push_back(point_of_monomials(cubics.cast<Complex>() * vector));
    }
    return points;
  }

  // Newton on both conics; the step is orthogonal to y. Keeps the best point met.
  Point improved(Point y) const {
    constexpr int kSteps = 4;
    Point best = y;
    double least = residual(y);
    for (int i = 0; i < kSteps; ++i) {
      Eigen::Matrix3cd jacobian;
      jacobian.row(0) = 2.0 * (a_ * y).transpose();
      jacobian.row(1) = 2.0 * (b_ * y).transpose();
      jacobian.row(2) = y.adjoint();
      const Point value((y.transpose() * a_ * y).value(), (y.transpose() * b_ * y).value(), 0.0);
      y = (y - jacobian.partialPivLu().solve(value)).normalized();
      const double now = residual(y);
      if (!(now < least)) {
        break;
      }
      least = now;
      best = y;
    }
    return best;
  }

  // Reciprocal of the smaller singular value of the two gradients at the point.
  double condition(const Point& y) const {
    const Point first = 2.0 * (a_ * y);
    const Point second = 2.0 * (b_ * y);
    const double sum = first.squaredNorm() + second.squaredNorm();
    const double overlap = std::norm(first.dot(second));
    const double determinant = first.squaredNorm() * second.squaredNorm() - overlap;
    const double larger = 0.5 * (sum + std::sqrt(std::max(sum * sum - 4.0 * determinant, 0.0)));
    return determinant > 0.0 ? std::sqrt(larger / determinant)
                             : std::numeric_limits<double>::infinity();
  }

  ConicPoint simple(const Point& rough) const {
    ConicPoint point;
    point.y = in_phase(improved(rough));
    point.condition = condition(point.y);
    point.is_real = point.y.imag().cwiseAbs().maxCoeff() < kRealPoint;
    if (point.is_real) {
      point.y = point.y.real().normalized().cast<Complex>();
    }
    return point;
  }

  // Rounding splits a double point by its square root to both sides; their mean is accurate.
  ConicPoint twofold(const Point& one, const Point& other) const {
    ConicPoint point;
    point.multiplicity = 2;
    point.y = in_phase((in_phase(one) + other * other.dot(in_phase(one))).normalized());
    point.condition = condition(point.y);
    point.is_real = point.y.imag().cwiseAbs().maxCoeff() < kDoublePoint;
    if (point.is_real) {
      point.y = point.y.real().normalized().cast<Complex>();
    }
    return point;
  }

  static double distance(const Point& one, const Point& other) {
    return (one - other * other.dot(one)).norm();
  }

  std::vector<ConicPoint> merged(const std::vector<Point>& rough) const {
    std::vector<ConicPoint> points;
    std::vector<bool> done(rough.size(), false);
    for (std::size_t i = 0; i < rough.size(); ++i) {
      if (done[i]) {
        continue;
      }
      std::size_t twin = i + 1;
      while (twin < rough.size() &&
             (done[twin] || distance(rough[i], rough[twin]) > kDoublePoint)) {
        ++twin;
      }
      if (twin < rough.size()) {
        done[twin] = true;
        points.push_back(twofold(rough[i], rough[twin]));
      } else {
        points.push_back(simple(rough[i]));
      }
    }
    return points;
  }

  // The two lines of a conic of rank two, if they are real.
  static std::optional<std::array<Vec3, 2>> lines_of(const Mat3& conic) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(conic);
    const Vec3 values = solver.eigenvalues();
    // Ascending: a pair of real lines has one value below zero, one above, and one near zero.
    if (!(values[0] < kRealPoint && values[2] > -kRealPoint)) {
      return std::nullopt;
    }
    const Vec3 plus = std::sqrt(std::max(values[2], 0.0)) * solver.eigenvectors().col(2);
    const Vec3 minus = std::sqrt(std::max(-values[0], 0.0)) * solver.eigenvectors().col(0);
    return std::array<Vec3, 2>{(plus + minus).normalized(), (plus - minus).normalized()};
  }

  // How far the conic is from holding the whole line.
  static double miss(const Mat3& conic, const Vec3& line) {
    const Vec3 p = line.unitOrthogonal();
    const Vec3 q = line.cross(p);
    return std::max(
        {std::abs(p.dot(conic * p)), std::abs(p.dot(conic * q)), std::abs(q.dot(conic * q))});
  }

  // The other line of a conic that holds this one: conic = line mᵀ + m lineᵀ.
  static Vec3 other_line(const Mat3& conic, const Vec3& line) {
    const Vec3 product = conic * line;
    return product - 0.5 * line.dot(product) * line;
  }

  void take_out_line(ConicIntersection& result) const {
    const auto lines = lines_of(a_);
    if (!lines) {
      return;
    }
    const auto& [one, other] = *lines;
    result.shared_line = miss(b_, one) <= miss(b_, other) ? one : other;
    const Vec3 point = other_line(a_, result.shared_line).cross(other_line(b_, result.shared_line));
    if (!(point.norm() > kSharedComponent)) {
      return;
    }
    ConicPoint isolated;
    isolated.y = in_phase(point.normalized().cast<Complex>());
    isolated.is_real = true;
    isolated.condition = condition(isolated.y);
    result.points.push_back(isolated);
  }

  Mat3 a_;
  Mat3 b_;
  bool is_one_conic_ = false;
};

}  // namespace

ConicIntersection intersect_conics(const Mat3& a, const Mat3& b) {
  if (!(a.norm() > 0.0 && b.norm() > 0.0)) {
    return {.points = {}, .shared = SharedPart::conic, .shared_line = Vec3::Zero(), .gap = 0.0};
  }
  return Intersection(a, b).run();
}

}  // namespace kinestat
