#include "math/dense/conic_intersection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/synthesis_tolerance.hpp"
#include "math/dense/internal/macaulay_matrix.hpp"

namespace kinestat {

namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector3cd;

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
    const MacaulayMatrix multiples(a_, b_);
    if (multiples.gap() < kSharedComponent) {
      result.shared = SharedPart::line;
      take_out_line(result);
      return result;
    }
    result.points = merged(multiples.rough_points());
    return result;
  }

 private:
  // Newton on both conics; the step is orthogonal to y. Keeps the best point met.
  Point improved(Point y) const {
    constexpr int kSteps = 4;
    Point best = y;
    double least = conic_miss(a_, b_, y);
    for (int i = 0; i < kSteps; ++i) {
      Eigen::Matrix3cd jacobian;
      jacobian.row(0) = 2.0 * (a_ * y).transpose();
      jacobian.row(1) = 2.0 * (b_ * y).transpose();
      jacobian.row(2) = y.adjoint();
      const Point value((y.transpose() * a_ * y).value(), (y.transpose() * b_ * y).value(), 0.0);
      y = (y - jacobian.partialPivLu().solve(value)).normalized();
      const double now = conic_miss(a_, b_, y);
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
    const Vec3& values = solver.eigenvalues();
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
    return {.points = {}, .shared = SharedPart::conic, .shared_line = Vec3::Zero()};
  }
  return Intersection(a, b).run();
}

}  // namespace kinestat
