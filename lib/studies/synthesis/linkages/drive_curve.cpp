#include "studies/synthesis/linkages/drive_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

// The angle with this cosine, which only rounding takes beyond a dead point; NaN out of reach.
double reached_angle(double cosine) {
  return std::abs(cosine) < 1.0 + kSameValue ? std::acos(std::clamp(cosine, -1.0, 1.0))
                                             : std::numeric_limits<double>::quiet_NaN();
}

// Normal of the path of a slider, or of the line of an inverted one in its own frame.
Point normal_of(const Dyad& dyad) {
  return left_of(dyad.direction);
}

// The force of the output on the coupler, where it acts and its direction.
struct Force {
  Point at;
  Point direction;
};

Force force_of(const Dyad& output, const Pose& pose) {
  const Point place = pose.place(output.circle_point);
  switch (output.kind) {
    case DyadKind::crank:
      return {.at = place, .direction = output.centre_point - place};
    case DyadKind::slider:
      return {.at = place, .direction = normal_of(output)};
    case DyadKind::inverted_slider:
      return {.at = output.centre_point, .direction = unit_vector(pose.angle) * normal_of(output)};
  }
  return {};
}

}  // namespace

DriveCurve::DriveCurve(const Linkage& linkage, Drive drive)
    : input_(input_of(linkage, drive)), output_(output_of(linkage, drive)) {
  switch (input_.kind) {
    case DyadKind::crank:
      set_crank_input();
      return;
    case DyadKind::slider:
      set_slider_input();
      return;
    case DyadKind::inverted_slider:
      set_inverted_input();
      return;
  }
}

// A = A0 + r e^{i(zero + x)}.
void DriveCurve::set_crank_input() {
  const double r = input_.length;
  argument_ = Argument::cosine;
  if (output_.kind == DyadKind::slider) {
    // n . (A - p) = h cos μ.
    const double h = std::abs(output_.circle_point - input_.circle_point);
    const Point normal = normal_of(output_);
    zero_ = std::arg(normal);
    constant_ = dot(normal, input_.centre_point - output_.centre_point) / h;
    factor_ = r / h;
    return;
  }
  const Point ground = output_.centre_point - input_.centre_point;
  const double g = std::abs(ground);
  zero_ = g > 0.0 ? std::arg(ground) : 0.0;
  // ρ² = g² + r² - 2 g r cos x is the square of the distance from A to the output's centre.
  constant_ = g * g + r * r;
  factor_ = -2.0 * g * r;
  if (output_.kind == DyadKind::crank) {
    const double h = std::abs(output_.circle_point - input_.circle_point);
    const double r2 = output_.length;
    const double scale = 2.0 * h * r2;
    constant_ = (h * h + r2 * r2 - constant_) / scale;
    factor_ = -factor_ / scale;
    return;
  }
  is_over_root_ = true;
  over_root_ = dot(normal_of(output_), input_.circle_point - output_.circle_point);
}

// A = foot + x * direction.
void DriveCurve::set_slider_input() {
  const Point along = input_.direction;
  const double h = std::abs(output_.circle_point - input_.circle_point);
  if (output_.kind == DyadKind::slider) {
    const Point normal = normal_of(output_);
    argument_ = Argument::linear;
    constant_ = dot(normal, input_.centre_point - output_.centre_point) / h;
    factor_ = dot(normal, along) / h;
    return;
  }
  argument_ = Argument::square;
  zero_ = dot(output_.centre_point - input_.centre_point, along);
  const double away = cross(along, output_.centre_point - input_.centre_point);
  constant_ = away * away;
  factor_ = 1.0;
  if (output_.kind == DyadKind::crank) {
    const double r2 = output_.length;
    const double scale = 2.0 * h * r2;
    constant_ = (h * h + r2 * r2 - constant_) / scale;
    factor_ = -1.0 / scale;
    return;
  }
  is_over_root_ = true;
  over_root_ = dot(normal_of(output_), input_.circle_point - output_.circle_point);
}

// The angle of the plane is zero + x; N is the normal of the input's line.
void DriveCurve::set_inverted_input() {
  const double own = std::arg(normal_of(input_));
  if (output_.kind == DyadKind::inverted_slider) {
    argument_ = Argument::none;
    constant_ = dot(normal_of(output_), normal_of(input_));
    return;
  }
  argument_ = Argument::cosine;
  if (output_.kind == DyadKind::slider) {
    zero_ = std::arg(normal_of(output_)) - own;
    factor_ = 1.0;
    is_open_ended_ = true;
    return;
  }
  // N . (B0 - B) = r2 cos μ, where N . (B - w) is constant.
  const Point arm = output_.centre_point - input_.centre_point;
  zero_ = (std::abs(arm) > 0.0 ? std::arg(arm) : 0.0) - own;
  constant_ = -dot(normal_of(input_), output_.circle_point - input_.circle_point) / output_.length;
  factor_ = std::abs(arm) / output_.length;
}

double DriveCurve::coordinate_of(const Pose& pose) const {
  switch (input_.kind) {
    case DyadKind::crank:
      return wrapped(std::arg(pose.place(input_.circle_point) - input_.centre_point) - zero_);
    case DyadKind::slider:
      return dot(pose.place(input_.circle_point) - input_.centre_point, input_.direction) - zero_;
    case DyadKind::inverted_slider:
      return wrapped(pose.angle - zero_);
  }
  return 0.0;
}

int DriveCurve::sense_of(const PositionJets& position) const {
  const std::vector<Point> place = point_jets(position, input_.circle_point);
  const Point arm = place[0] - input_.centre_point;
  const Point along =
      input_.kind == DyadKind::crank ? left_of(arm) / std::abs(arm) : input_.direction;
  const bool turns = input_.kind == DyadKind::inverted_slider;
  const double rate = turns ? position.angle[1] : dot(along, place[1]);
  const double size = turns ? std::abs(rate) : std::abs(place[1]);
  return !(std::abs(rate) > kCancellation * size) ? 0 : (rate > 0.0 ? 1 : -1);
}

int DriveCurve::side_of(const Pose& pose) const {
  const Force force = force_of(output_, pose);
  if (input_.kind == DyadKind::inverted_slider && output_.kind == DyadKind::inverted_slider) {
    return 0;
  }
  const double work = input_.kind == DyadKind::inverted_slider
                          ? dot(force.direction, unit_vector(pose.angle) * input_.direction)
                          : cross(force.at - pose.place(input_.circle_point), force.direction);
  return work > 0.0 ? 1 : (work < 0.0 ? -1 : 0);
}

double DriveCurve::cosine(double x) const {
  double argument = 0.0;
  switch (argument_) {
    case Argument::cosine:
      argument = std::cos(x);
      break;
    case Argument::square:
      argument = x * x;
      break;
    case Argument::linear:
      argument = x;
      break;
    case Argument::none:
      break;
  }
  const double s = constant_ + factor_ * argument;
  return is_over_root_ ? over_root_ / std::sqrt(s) : s;
}

DriveCurve::Range DriveCurve::range() const {
  const Range whole = argument_ == Argument::cosine   ? Range{-1.0, 1.0}
                      : argument_ == Argument::square ? Range{0.0, kInfinity}
                                                      : Range{-kInfinity, kInfinity};
  if (factor_ == 0.0) {
    return whole;
  }
  // s from -1 to 1, or above over_root².
  const double a = ((is_over_root_ ? over_root_ * over_root_ : -1.0) - constant_) / factor_;
  const double b =
      is_over_root_ ? (factor_ > 0.0 ? kInfinity : -kInfinity) : (1.0 - constant_) / factor_;
  const auto [low, high] = std::minmax(a, b);
  return {.low = std::max(low, whole.low), .high = std::min(high, whole.high)};
}

Point DriveCurve::input_place(double x) const {
  return input_.kind == DyadKind::crank
             ? input_.centre_point + input_.length * unit_vector(zero_ + x)
             : input_.centre_point + (zero_ + x) * input_.direction;
}

// The angle of the plane from the place of the input's circle point; NaN out of reach.
double DriveCurve::plane_angle(const Point& input_place, int side) const {
  const Point arm = output_.circle_point - input_.circle_point;
  if (output_.kind == DyadKind::slider) {
    const Point normal = normal_of(output_);
    const double away = dot(normal, input_place - output_.centre_point);
    return std::arg(normal) - side * reached_angle(-away / std::abs(arm)) - std::arg(arm);
  }
  const Point to_centre = output_.centre_point - input_place;
  const double rho = std::abs(to_centre);
  if (output_.kind == DyadKind::crank) {
    const double h = std::abs(arm);
    const double cosine = (h * h + rho * rho - output_.length * output_.length) / (2.0 * h * rho);
    return std::arg(to_centre) - side * reached_angle(cosine) - std::arg(arm);
  }
  return std::arg(to_centre) + side * reached_angle(-over_root_ / rho) -
         std::arg(normal_of(output_));
}

Pose DriveCurve::pose_of_inverted_input(double x, int side) const {
  Pose pose{.origin = {}, .angle = zero_ + x};
  const Point normal = unit_vector(pose.angle) * normal_of(input_);
  const Point along = unit_vector(pose.angle) * input_.direction;
  const double offset = dot(normal_of(input_), output_.circle_point - input_.circle_point);
  if (output_.kind == DyadKind::crank) {
    const Point arm = unit_vector(side * reached_angle(cosine(x)));
    const Point place =
        output_.centre_point - output_.length * (arm.real() * normal + arm.imag() * along);
    pose.origin = place - unit_vector(pose.angle) * output_.circle_point;
    return pose;
  }
  // The line along which the output's circle point is led, cut with what the output asks for.
  const Point place = input_.centre_point + offset * normal;
  const Point other_normal = output_.kind == DyadKind::slider
                                 ? normal_of(output_)
                                 : unit_vector(pose.angle) * normal_of(output_);
  const double slide = dot(other_normal, output_.centre_point - place) / dot(other_normal, along);
  pose.origin = place + slide * along - unit_vector(pose.angle) * output_.circle_point;
  return pose;
}

std::optional<Pose> DriveCurve::pose_at(double x, int side) const {
  Pose pose;
  if (input_.kind == DyadKind::inverted_slider) {
    pose = pose_of_inverted_input(x, side);
  } else {
    const Point place = input_place(x);
    pose.angle = plane_angle(place, side);
    pose.origin = place - unit_vector(pose.angle) * input_.circle_point;
  }
  const bool is_finite = std::isfinite(pose.angle) && std::isfinite(pose.origin.real()) &&
                         std::isfinite(pose.origin.imag());
  return is_finite ? std::optional(pose) : std::nullopt;
}

}  // namespace kinestat
