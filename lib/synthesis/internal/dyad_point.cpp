#include "synthesis/internal/dyad_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/tolerance.hpp"
#include "math/dense_solve.hpp"
#include "synthesis/internal/condition_space.hpp"
#include "synthesis/internal/straight_fit.hpp"

namespace kinestat {

namespace {

// Numerator by denominator; `is_far` where the denominator is zero as far as one can tell.
struct Quotient {
  Point numerator;
  Point denominator;

  bool is_far(double error) const { return !(std::abs(denominator) > error); }

  Point value() const { return numerator / denominator; }
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

// A dyad with a far point, improved where there are conditions enough.
StraightDyad improved(const ConditionRows& system,
                      FarPoint far,
                      const Point& finite,
                      const Point& normal) {
  const StraightDyad start{.finite = finite, .normal = normal / std::abs(normal), .misses = {}};
  if (system.rows.size() != 4) {
    return start;
  }
  return fit_straight(straight_conditions(system).rows, system.noise, far, start);
}

// Whether a point differs from a quotient by no more than an error explains. A crank that the error
// does not tell from a slider may lead to another slider.
bool is_close(const Point& found, const Quotient& start, double error) {
  const double size = std::max(1.0, std::abs(start.value()));
  return std::abs(found - start.value()) <= size * error / std::abs(start.denominator);
}

// Whether both points lie further away than an error can tell that is too large to call it
// infinity.
bool is_lost(const Quotient& z, const Quotient& w, double error) {
  return error > kRealPoint && std::abs(z.denominator) > 0.0 && std::abs(w.denominator) > 0.0;
}

// What rounding to the last decimal may do to each condition of a slider: to the places of its
// position and of the first one, in both coordinates, and to their turns about its point.
std::vector<double> allowances_of(const StraightConditions& conditions,
                                  const LastDecimal& decimal,
                                  double length,
                                  double distance) {
  const double places = 2.0 * std::numbers::sqrt2 * decimal.length / length;
  const double turns = 2.0 * decimal.angle * (distance + conditions.radius);
  std::vector<double> allowances;
  for (std::size_t i = 0; i < conditions.slopes.size(); ++i) {
    allowances.push_back((places + turns) * conditions.slopes[i] + conditions.noise[i]);
  }
  return allowances;
}

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

  Dyad straight(const StraightDyad& dyad, FarPoint far) const {
    return far == FarPoint::centre ? slider(dyad.finite, dyad.normal)
                                   : inverted_slider(dyad.finite, dyad.normal);
  }

 private:
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
                            const PositionJets& first,
                            double error) {
  const Homogeneous point(x);
  const Quotient z = point.circle_point();
  const Quotient w = point.centre_point();
  const DyadMaker make(system, first);
  // Positions that were computed carry a few roundings each.
  constexpr double kRoundings = 8.0;
  const double least = std::max(kRoundings * error, kCancellation);
  const bool far_circle = z.is_far(least);
  const bool far_centre = w.is_far(least);
  if (far_circle && far_centre) {
    return is_lost(z, w, error) ? std::optional(make.crank(z.value(), w.value())) : std::nullopt;
  }
  if (far_centre || far_circle) {
    const FarPoint far = far_centre ? FarPoint::centre : FarPoint::circle_point;
    const Quotient& near = far_centre ? z : w;
    const StraightDyad straight =
        improved(system, far, near.value(), far_centre ? point.centre : point.circle);
    if (is_close(straight.finite, near, std::max(error, kCancellation))) {
      return make.straight(straight, far);
    }
  }
  CrankImprover improver(system, z.value(), w.value());
  if (system.rows.size() == 4) {
    improver.run();
  }
  return make.crank(improver.circle_point(), improver.centre());
}

std::optional<Dyad> find_straight(const Eigen::Matrix<double, 7, 1>& x,
                                  const StraightConditions& conditions,
                                  const LastDecimal& decimal,
                                  const ConditionRows& system,
                                  const PositionJets& first) {
  const Homogeneous point(x);
  const Point z = point.circle_point().value();
  const Point w = point.centre_point().value();
  const FarPoint far = std::abs(w) > std::abs(z) ? FarPoint::centre : FarPoint::circle_point;
  const Point& near = far == FarPoint::centre ? z : w;
  const bool is_written = decimal.length > 0.0 || decimal.angle > 0.0;
  if (!is_written || !(std::abs(near) < kLongCrank)) {
    return std::nullopt;
  }
  const Point normal = (z - w) / std::abs(z - w);
  const std::vector<double> allowances =
      allowances_of(conditions, decimal, system.length, std::abs(near));
  const StraightDyad straight = fit_straight(
      conditions.rows, allowances, far, {.finite = near, .normal = normal, .misses = {}});
  if (!straight.is_within(allowances)) {
    return std::nullopt;
  }
  const DyadMaker make(system, first);
  Dyad dyad = make.straight(straight, far);
  dyad.crank_length = system.length * std::abs(z - w);
  dyad.deviation = system.length * straight.deviation(conditions.slopes);
  dyad.digits = digits_of(std::max(straight.uncertainty, kEpsilon));
  return dyad;
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
