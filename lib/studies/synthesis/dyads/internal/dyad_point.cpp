#include "studies/synthesis/dyads/internal/dyad_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "core/rounding.hpp"
#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/dense/dense_solve.hpp"
#include "studies/synthesis/dyads/bounded_point.hpp"
#include "studies/synthesis/dyads/internal/condition_space.hpp"
#include "studies/synthesis/dyads/internal/straight_fit.hpp"

namespace kinestat {

namespace {

// The rounding of data by that of a double, in which the noise of conditions is counted.
constexpr double kDataShare = kDataRounding / kEpsilon;

// Both coordinates by the same.
constexpr Point kBoth = {1.0, 1.0};

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

// Circle point and centre as (x, y, h), h = 0 at infinity, and by how much each coordinate may be
// changed before a condition tells that from rounding of the positions. Where errors of
// coordinates hang together, that is far less than what they may be off by, and a dyad keeps to
// the positions whichever of its coordinates become zero.
class DyadPoints {
 public:
  DyadPoints(const ConditionRows& system, const Point& z, double h_z, const Point& w, double h_w)
      : z_(z), w_(w), h_z_(h_z), h_w_(h_w), terms_(terms()) {
    for (std::size_t i = 0; i < system.rows.size(); ++i) {
      add_condition(system.rows[i], kDataShare * system.noise[i] * terms_);
    }
    if (system.rows.empty()) {  // which were solved with more digits than the dyad is told in
      circle_bound_ = kDataRounding * std::abs(z) * kBoth;
      centre_bound_ = kDataRounding * std::abs(w) * kBoth;
    }
  }

  BoundedPoint circle_point() const { return BoundedPoint::within(z_, circle_bound_); }

  BoundedPoint centre() const { return BoundedPoint::within(w_, centre_bound_); }

 private:
  double terms() const {
    return h_w_ * (std::abs(z_.real()) + std::abs(z_.imag())) +
           h_z_ * (std::abs(w_.real()) + std::abs(w_.imag())) +
           (std::abs(z_.real()) + std::abs(z_.imag())) *
               (std::abs(w_.real()) + std::abs(w_.imag())) +
           h_z_ * h_w_;
  }

  // The slopes of its sum, which is bilinear in the two points.
  void add_condition(const std::array<double, 7>& r, double error) {
    const Point of_circle = {r[0] * h_w_ + r[4] * w_.real() + r[5] * w_.imag(),
                             r[1] * h_w_ + r[4] * w_.imag() - r[5] * w_.real()};
    const Point of_centre = {r[2] * h_z_ + r[4] * z_.real() - r[5] * z_.imag(),
                             r[3] * h_z_ + r[4] * z_.imag() + r[5] * z_.real()};
    circle_bound_ = least(circle_bound_, error, of_circle);
    centre_bound_ = least(centre_bound_, error, of_centre);
  }

  static Point least(const Point& bound, double error, const Point& slopes) {
    return {std::min(bound.real(), error / std::abs(slopes.real())),
            std::min(bound.imag(), error / std::abs(slopes.imag()))};
  }

  static constexpr double kOpen = std::numeric_limits<double>::infinity();

  Point z_;
  Point w_;
  double h_z_;
  double h_w_;
  double terms_;
  Point circle_bound_ = {kOpen, kOpen};
  Point centre_bound_ = {kOpen, kOpen};
};

// From the units of a system to those of the task.
class DyadMaker {
 public:
  DyadMaker(const ConditionRows& system, const PositionJets& first)
      : system_(system),
        length_(system.length),
        origin_(system.x, system.y),
        frame_origin_(origin(first)),
        to_moving_(unit_vector(-first.angle[0])) {}

  Dyad crank(const Point& z, const Point& w) const {
    const DyadPoints points(system_, z, 1.0, w, 1.0);
    Dyad dyad{.kind = DyadKind::crank};
    set_circle_point(moving(points.circle_point()), dyad);
    set_centre(fixed(points.centre()), dyad);
    dyad.length = length_ * std::abs(z - w);
    return dyad;
  }

  Dyad straight(const StraightDyad& dyad, FarPoint far) const {
    if (far == FarPoint::centre) {
      const DyadPoints points(system_, dyad.finite, 1.0, dyad.normal, 0.0);
      return slider(points.circle_point(), points.centre());
    }
    const DyadPoints points(system_, dyad.normal, 0.0, dyad.finite, 1.0);
    return inverted_slider(points.centre(), points.circle_point());
  }

 private:
  Dyad slider(const BoundedPoint& z, const BoundedPoint& normal) const {
    Dyad dyad{.kind = DyadKind::slider};
    set_circle_point(moving(z), dyad);
    set_centre(fixed(z), dyad);
    set_direction(turned_left(normal), dyad);
    return dyad;
  }

  Dyad inverted_slider(const BoundedPoint& w, const BoundedPoint& normal) const {
    Dyad dyad{.kind = DyadKind::inverted_slider};
    const BoundedPoint along = turned(turned_left(normal), kDataRounding);
    const BoundedPoint point = moving(w);
    set_circle_point(point - dot(point, along) * along, dyad);
    set_centre(fixed(w), dyad);
    set_direction(along, dyad);
    return dyad;
  }

  static BoundedPoint turned_left(const BoundedPoint& a) {
    return {.x = exactly(0.0) - a.y, .y = a.x};
  }

  // Plain numbers: a search makes so many dyads that sums with bounds of their own would show.
  BoundedPoint fixed(const BoundedPoint& z) const {
    const Point place = origin_ + length_ * z.value();
    const double rounding = kEpsilon * (std::abs(origin_) + length_ * std::abs(z.value()));
    return BoundedPoint::within(place, length_ * z.bound() + rounding * kBoth);
  }

  BoundedPoint moving(const BoundedPoint& z) const {
    const Point arm = (origin_ - frame_origin_) + length_ * z.value();
    const double terms =
        std::abs(origin_) + std::abs(frame_origin_) + length_ * std::abs(z.value());
    return turned(BoundedPoint::within(arm, length_ * z.bound()),
                  kDataRounding * std::abs(arm) + 2.0 * kEpsilon * terms);
  }

  // Into the moving frame; `rounding` is that of the turn.
  BoundedPoint turned(const BoundedPoint& a, double rounding) const {
    const double c = std::abs(to_moving_.real());
    const double s = std::abs(to_moving_.imag());
    return BoundedPoint::within(
        to_moving_ * a.value(),
        {c * a.x.bound + s * a.y.bound + rounding, s * a.x.bound + c * a.y.bound + rounding});
  }

  static void set_circle_point(const BoundedPoint& point, Dyad& dyad) {
    dyad.circle_point = point.zeroed();
    dyad.circle_bound = point.bound();
  }

  static void set_centre(const BoundedPoint& point, Dyad& dyad) {
    dyad.centre_point = point.zeroed();
    dyad.centre_bound = point.bound();
  }

  // Of the two directions of a line the one to the right, and of a vertical one upwards. Bounds
  // that tell neither component from zero know no direction better than the numbers do.
  static void set_direction(const BoundedPoint& along, Dyad& dyad) {
    const Point zeroed = along.zeroed();
    const Point direction = zeroed == Point() ? along.value() : zeroed;
    const bool flips =
        direction.real() < 0.0 || (direction.real() == 0.0 && direction.imag() < 0.0);
    dyad.direction = (flips ? -direction : direction) / std::abs(direction) + Point(0.0, 0.0);
    dyad.direction_bound = along.bound();
  }

  const ConditionRows& system_;
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
    const Point& normal = far_centre ? point.centre : point.circle;
    const StraightDyad straight = improved(system, far, near.value(), normal);
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
