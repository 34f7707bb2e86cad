#include "synthesis/internal/dyad_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/dense_solve.hpp"

namespace kinestat {

namespace {

// Numerator by denominator; `is_far` where the quotient is beyond all sizes of the task.
struct Quotient {
  Point numerator;
  Point denominator;

  bool is_far() const { return std::abs(numerator) > kInfinitePoint * std::abs(denominator); }

  bool is_empty() const { return std::abs(numerator) + std::abs(denominator) < kCancellation; }
};

struct Homogeneous {
  Point circle;       // z h
  Point centre;       // w h
  Point product;      // z conj(w) h
  double weight = 0;  // h

  explicit Homogeneous(const Eigen::Matrix<double, 7, 1>& x) {
    const double largest = x.cwiseAbs().maxCoeff();
    circle = Point(x[0], x[1]) / largest;
    centre = Point(x[2], x[3]) / largest;
    product = Point(x[4], -x[5]) / largest;
    weight = x[6] / largest;
  }

  Quotient circle_point() const {
    return std::abs(centre) > std::abs(weight) ? Quotient{product, std::conj(centre)}
                                               : Quotient{circle, weight};
  }

  Quotient centre_point() const {
    return std::abs(circle) > std::abs(weight) ? Quotient{std::conj(product), std::conj(circle)}
                                               : Quotient{centre, weight};
  }
};

// A crank in the units of the system, improved by Newton on its conditions, which are bilinear in
// circle point and centre. Their residuals are summed with more digits than they are stored with.
class CrankImprover {
 public:
  CrankImprover(const ConditionRows& system, const Point& z, const Point& w)
      : system_(system), at_(z.real(), z.imag(), w.real(), w.imag()) {}

  void run() {
    constexpr int kSteps = 3;
    double least = residuals().cwiseAbs().maxCoeff();
    for (int i = 0; i < kSteps && least > 0.0; ++i) {
      const Eigen::Vector4d before = at_;
      const auto step = solve_dense(jacobian(), residuals());
      if (!step) {
        return;
      }
      at_ -= *step;
      const double now = residuals().cwiseAbs().maxCoeff();
      if (!(now < least)) {
        at_ = before;
        return;
      }
      least = now;
    }
  }

  Point circle_point() const { return {at_[0], at_[1]}; }

  Point centre() const { return {at_[2], at_[3]}; }

 private:
  VecX residuals() const {
    const long double u = at_[0];
    const long double v = at_[1];
    const long double a = at_[2];
    const long double b = at_[3];
    const std::array<long double, 7> x = {u, v, a, b, a * u + b * v, b * u - a * v, 1.0L};
    VecX result(static_cast<Eigen::Index>(system_.rows.size()));
    for (std::size_t i = 0; i < system_.rows.size(); ++i) {
      long double sum = 0.0L;
      for (std::size_t j = 0; j < x.size(); ++j) {
        sum += static_cast<long double>(system_.rows[i][j]) * x[j];
      }
      result[static_cast<Eigen::Index>(i)] = static_cast<double>(sum);
    }
    return result;
  }

  MatX jacobian() const {
    MatX result(static_cast<Eigen::Index>(system_.rows.size()), 4);
    for (std::size_t i = 0; i < system_.rows.size(); ++i) {
      const std::array<double, 7>& r = system_.rows[i];
      result.row(static_cast<Eigen::Index>(i)) << r[0] + r[4] * at_[2] + r[5] * at_[3],
          r[1] + r[4] * at_[3] - r[5] * at_[2], r[2] + r[4] * at_[0] - r[5] * at_[1],
          r[3] + r[4] * at_[1] + r[5] * at_[0];
    }
    return result;
  }

  const ConditionRows& system_;
  Eigen::Vector4d at_;
};

class DyadMaker {
 public:
  DyadMaker(const ConditionRows& system, const PositionJets& first)
      : length_(system.length),
        origin_(system.x, system.y),
        frame_origin_(origin(first)),
        to_moving_(unit_vector(-first.angle[0])) {}

  Dyad crank(const Point& z, const Point& w) const {
    Dyad dyad{.kind = DyadKind::crank, .circle_point = moving(z), .centre_point = fixed(w)};
    dyad.length = length_ * std::abs(z - w);
    return dyad;
  }

  Dyad slider(const Point& z, const Point& normal) const {
    return {.kind = DyadKind::slider,
            .circle_point = moving(z),
            .centre_point = fixed(z),
            .direction = upward(left_of(normal) / std::abs(normal))};
  }

  Dyad inverted_slider(const Point& w, const Point& normal) const {
    const Point along = upward(to_moving_ * left_of(normal) / std::abs(normal));
    const Point foot = moving(w) - along * dot(moving(w), along);
    return {.kind = DyadKind::inverted_slider,
            .circle_point = foot,
            .centre_point = fixed(w),
            .direction = along};
  }

 private:
  Point fixed(const Point& z) const { return origin_ + length_ * z; }

  Point moving(const Point& z) const {
    return to_moving_ * ((origin_ - frame_origin_) + length_ * z);
  }

  // Of the two directions of a line the one to the right, and of a vertical one upwards.
  static Point upward(const Point& direction) {
    const bool flips =
        direction.real() < 0.0 || (direction.real() == 0.0 && direction.imag() < 0.0);
    return flips ? -direction : direction;
  }

  double length_;
  Point origin_;
  Point frame_origin_;
  Point to_moving_;
};

}  // namespace

std::optional<Dyad> dyad_of(const Eigen::Matrix<double, 7, 1>& x,
                            const ConditionRows& system,
                            const PositionJets& first) {
  const Homogeneous point(x);
  const Quotient z = point.circle_point();
  const Quotient w = point.centre_point();
  const DyadMaker make(system, first);
  const bool far_circle = z.is_far() || z.is_empty();
  const bool far_centre = w.is_far() || w.is_empty();
  if (far_circle && far_centre) {
    return std::nullopt;
  }
  if (far_centre) {
    return make.slider(z.numerator / z.denominator, point.centre);
  }
  if (far_circle) {
    return make.inverted_slider(w.numerator / w.denominator, point.circle);
  }
  CrankImprover improver(system, z.numerator / z.denominator, w.numerator / w.denominator);
  if (system.rows.size() == 4) {
    improver.run();
  }
  return make.crank(improver.circle_point(), improver.centre());
}

double smallest_denominator(const Eigen::Matrix<double, 7, 1>& x, DyadKind kind) {
  const Homogeneous point(x);
  const double of_circle_point = std::abs(point.circle_point().denominator);
  const double of_centre = std::abs(point.centre_point().denominator);
  switch (kind) {
    case DyadKind::crank:
      return std::min(of_circle_point, of_centre);
    case DyadKind::slider:
      return of_circle_point;
    case DyadKind::inverted_slider:
      return of_centre;
  }
  return 0.0;
}

}  // namespace kinestat
