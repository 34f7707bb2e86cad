#include "studies/synthesis/linkages/drive_curve.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/rounding.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/synthesis/linkages/rounded_dyad.hpp"

namespace kinestat {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int sign_of(double value) {
  return value > 0.0 ? 1 : (value < 0.0 ? -1 : 0);
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

// The angle whose cosine is so far below 1 and above -1, both by any common factor: the cosine
// itself has lost half of the digits next to 0 and π. Zero or π beyond.
double angle_between(double below_one, double above_minus_one) {
  return 2.0 *
         std::atan2(std::sqrt(std::max(below_one, 0.0)), std::sqrt(std::max(above_minus_one, 0.0)));
}

// The same, which only rounding takes beyond a dead point; NaN out of reach.
double reached_angle(double below_one, double above_minus_one) {
  const double rounding = 0.5 * kSameValue * (below_one + above_minus_one);
  return std::min(below_one, above_minus_one) > -rounding
             ? angle_between(below_one, above_minus_one)
             : std::numeric_limits<double>::quiet_NaN();
}

BoundedNumber operator-(const BoundedNumber& a) {
  return {.value = -a.value, .bound = a.bound};
}

// A sum of lengths that are rounded themselves.
double length_sum(std::initializer_list<BoundedNumber> terms) {
  double sum = 0.0;
  double bound = 0.0;
  for (const BoundedNumber& term : terms) {
    sum += term.value;
    bound += term.bound + kDataRounding * std::abs(term.value);
  }
  return zero_within_bound(sum, bound);
}

// a² - b².
double difference_of_squares(std::initializer_list<BoundedNumber> a_minus_b,
                             std::initializer_list<BoundedNumber> a_plus_b) {
  return length_sum(a_minus_b) * length_sum(a_plus_b);
}

// Normal of the path of a slider, or of the line of an inverted one in its own frame.
BoundedPoint normal_of(const Dyad& dyad) {
  const BoundedPoint along = direction_of(dyad);
  return {.x = -along.y, .y = along.x};
}

// The force of the output on the coupler, and from where it acts to the input's circle point; or
// the normal of the line of an inverted input.
struct Lever {
  BoundedPoint arm;
  BoundedPoint force;
};

// Between two points of the plane first, which no place of the plane rounds.
Lever lever_of(const Dyad& input, const Dyad& output, const Pose& pose) {
  const BoundedPoint turn = bounded_unit_vector(pose.angle);
  const bool slides = input.kind == DyadKind::inverted_slider;
  const BoundedPoint from = circle_point_of(output);
  Lever lever{.arm = turn * (slides ? normal_of(input) : circle_point_of(input) - from),
              .force = normal_of(output)};
  switch (output.kind) {
    case DyadKind::crank:
      lever.force = centre_point_of(output) - pose.bounded_place(turn, from);
      break;
    case DyadKind::slider:
      break;
    case DyadKind::inverted_slider:
      lever.force = turn * lever.force;
      if (!slides) {
        lever.arm = pose.bounded_place(turn, circle_point_of(input)) - centre_point_of(output);
      }
      break;
  }
  return lever;
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
  const BoundedNumber r = length_of(input_);
  argument_ = Argument::cosine;
  if (output_.kind == DyadKind::slider) {
    // n . (A - p) = h cos μ.
    const BoundedPoint normal = normal_of(output_);
    zero_ = std::arg(normal.value());
    set_cosine(dot(normal, centre_point_of(input_) - centre_point_of(output_)), r, coupler());
    return;
  }
  // ρ² = g² + r² - 2 g r cos x is the square of the distance from A to the output's centre.
  const Point ground = output_.centre_point - input_.centre_point;
  const BoundedNumber g = distance(centre_point_of(input_), centre_point_of(output_));
  zero_ = g.value > 0.0 ? std::arg(ground) : 0.0;
  if (output_.kind == DyadKind::crank) {
    // ρ² = h² + k² - 2 h k cos μ.
    const BoundedNumber h = coupler();
    const BoundedNumber k = length_of(output_);
    const double product = h.value * k.value;
    below_one_ = difference_of_squares({g, -r, -h, k}, {g, -r, h, -k}) / (2.0 * product);
    above_minus_one_ = difference_of_squares({h, k, -g, -r}, {h, k, g, r}) / (2.0 * product);
    factor_ = g.value * r.value / product;
    return;
  }
  const BoundedNumber away = set_over_root();
  excess_ = difference_of_squares({g, -r, -away}, {g, -r, away});
  factor_ = -2.0 * g.value * r.value;
}

// A = foot + x * direction.
void DriveCurve::set_slider_input() {
  const BoundedPoint along = direction_of(input_);
  const BoundedNumber h = coupler();
  if (output_.kind == DyadKind::slider) {
    const BoundedPoint normal = normal_of(output_);
    const BoundedNumber e = dot(normal, centre_point_of(input_) - centre_point_of(output_));
    argument_ = Argument::linear;
    below_one_ = length_sum({h, -e}) / h.value;
    above_minus_one_ = length_sum({h, e}) / h.value;
    factor_ = dot(normal, along).zeroed() / h.value;
    return;
  }
  // ρ² = away² + x².
  argument_ = Argument::square;
  const BoundedPoint ground = centre_point_of(output_) - centre_point_of(input_);
  zero_ = dot(ground.value(), input_.direction);
  const BoundedNumber away = cross(along, ground);
  if (output_.kind == DyadKind::crank) {
    const BoundedNumber k = length_of(output_);
    const double product = h.value * k.value;
    below_one_ = difference_of_squares({away, -h, k}, {away, h, -k}) / (2.0 * product);
    above_minus_one_ = difference_of_squares({h, k, -away}, {h, k, away}) / (2.0 * product);
    factor_ = -0.5 / product;
    return;
  }
  const BoundedNumber offset = set_over_root();
  excess_ = difference_of_squares({away, -offset}, {away, offset});
  factor_ = 1.0;
}

// The angle of the plane is zero + x; N is the normal of the input's line.
void DriveCurve::set_inverted_input() {
  const BoundedPoint normal = normal_of(input_);
  if (output_.kind == DyadKind::inverted_slider) {
    argument_ = Argument::none;
    below_one_ = 0.5 * std::norm((normal_of(output_) - normal).zeroed());
    above_minus_one_ = 0.5 * std::norm((normal_of(output_) + normal).zeroed());
    return;
  }
  argument_ = Argument::cosine;
  if (output_.kind == DyadKind::slider) {
    zero_ = std::arg(normal_of(output_).value()) - std::arg(normal.value());
    factor_ = 1.0;
    is_open_ended_ = true;
    return;
  }
  // N . (B0 - B) = r2 cos μ, where N . (B - w) is constant.
  const Point arm = output_.centre_point - input_.centre_point;
  zero_ = (std::abs(arm) > 0.0 ? std::arg(arm) : 0.0) - std::arg(normal.value());
  set_cosine(-dot(normal, circle_point_of(output_) - circle_point_of(input_)),
             distance(centre_point_of(input_), centre_point_of(output_)),
             length_of(output_));
}

// cos μ = (constant + arm cos x) / length.
void DriveCurve::set_cosine(const BoundedNumber& constant,
                            const BoundedNumber& arm,
                            const BoundedNumber& length) {
  const BoundedNumber offset = {.value = constant.zeroed(), .bound = constant.bound};
  below_one_ = length_sum({length, -offset, -arm}) / length.value;
  above_minus_one_ = length_sum({length, offset, -arm}) / length.value;
  factor_ = arm.value / length.value;
}

// ρ cos μ is how far the line is from the input's circle point.
BoundedNumber DriveCurve::set_over_root() {
  is_over_root_ = true;
  const BoundedNumber away =
      dot(normal_of(output_), circle_point_of(input_) - circle_point_of(output_));
  over_root_ = away.value;
  return away;
}

BoundedNumber DriveCurve::coupler() const {
  return distance(circle_point_of(input_), circle_point_of(output_));
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
  const double turn = position.angle[1];
  if (input_.kind == DyadKind::inverted_slider) {
    return sign_of(turn);
  }
  const std::vector<Point> place = point_jets(position, input_.circle_point);
  const Point arm = place[0] - input_.centre_point;
  const Point along =
      input_.kind == DyadKind::crank ? left_of(arm) / std::abs(arm) : input_.direction;
  // Where the circle point is the pole, what is left of both terms is their rounding.
  const double bound =
      kDataRounding * (std::abs(origin(position, 1)) + std::abs(turn * input_.circle_point)) +
      std::abs(turn) * std::abs(circle_point_of(input_).bound());
  const double rate = dot(along, place[1]);
  return sign_of(zero_within_bound(rate, bound + kCancellation * std::abs(place[1])));
}

DriveCurve::Offset DriveCurve::offset_of(double x) const {
  switch (argument_) {
    case Argument::cosine: {
      const double sine = std::sin(0.5 * x);
      const double cosine = std::cos(0.5 * x);
      return {.from_one = -2.0 * sine * sine, .from_minus_one = 2.0 * cosine * cosine};
    }
    case Argument::square:
      return {.from_one = x * x, .from_minus_one = x * x};
    case Argument::linear:
      return {.from_one = x, .from_minus_one = x};
    case Argument::none:
      break;
  }
  return {};
}

double DriveCurve::below_one(const Offset& at) const {
  return below_one_ - factor_ * at.from_one;
}

double DriveCurve::above_minus_one(const Offset& at) const {
  return above_minus_one_ + factor_ * at.from_minus_one;
}

double DriveCurve::transmission_at(const Offset& at) const {
  return is_over_root_
             ? std::atan2(std::sqrt(std::max(excess_ + factor_ * at.from_one, 0.0)), over_root_)
             : angle_between(below_one(at), above_minus_one(at));
}

double DriveCurve::transmission(double x) const {
  return transmission_at(offset_of(x));
}

DriveCurve::Transmission DriveCurve::transmission_of(const Pose& pose) const {
  const Lever lever = lever_of(input_, output_, pose);
  const double across = cross(lever.arm, lever.force).zeroed();
  return {.angle = std::atan2(std::abs(across), dot(lever.arm.value(), lever.force.value())),
          .side = argument_ == Argument::none ? 0 : -sign_of(across)};
}

double DriveCurve::reserve(double x) const {
  const Offset at = offset_of(x);
  if (!is_over_root_) {
    return std::min(below_one(at), above_minus_one(at));
  }
  const double excess = excess_ + factor_ * at.from_one;
  const double reach = over_root_ * over_root_ + excess;  // ρ²
  return reach > 0.0 ? excess / (reach + std::abs(over_root_) * std::sqrt(reach)) : -1.0;
}

// cos μ falls with x, and an output that is an inverted slider has a dead point at one end alone.
DriveCurve::Range DriveCurve::range_of_angle() const {
  Range range{.low = 0.0, .high = std::numbers::pi};
  range.low_transmission = transmission(range.low);
  range.high_transmission = transmission(range.high);
  if (factor_ == 0.0) {
    return range;
  }
  const double before = is_over_root_ ? excess_ / factor_ : -below_one_ / factor_;
  if (before > 0.0) {
    range.low = angle_between(before, 2.0 - before);
    range.low_transmission = is_over_root_ ? std::atan2(0.0, over_root_) : 0.0;
  }
  const double after = is_over_root_ ? 0.0 : -above_minus_one_ / factor_;
  if (after > 0.0) {
    range.high = angle_between(2.0 - after, after);
    range.high_transmission = std::numbers::pi;
  }
  return range;
}

DriveCurve::Range DriveCurve::range_of_square() const {
  Range range{.low = 0.0, .high = kInfinity};
  const double before = is_over_root_ ? -excess_ : below_one_ / factor_;
  range.low = std::sqrt(std::max(before, 0.0));
  if (is_over_root_) {
    range.low_transmission = before > 0.0 ? std::atan2(0.0, over_root_) : transmission(0.0);
    range.high_transmission = 0.5 * std::numbers::pi;
    return range;
  }
  range.low_transmission = before > 0.0 ? 0.0 : transmission(0.0);
  range.high = std::sqrt(std::max(-above_minus_one_ / factor_, 0.0));
  range.high_transmission = std::numbers::pi;
  return range;
}

DriveCurve::Range DriveCurve::range_of_line() const {
  if (factor_ == 0.0) {
    const double same = transmission(0.0);
    return {
        .low = -kInfinity, .high = kInfinity, .low_transmission = same, .high_transmission = same};
  }
  const double one = below_one_ / factor_;
  const double minus_one = -above_minus_one_ / factor_;
  return one < minus_one ? Range{.low = one,
                                 .high = minus_one,
                                 .low_transmission = 0.0,
                                 .high_transmission = std::numbers::pi}
                         : Range{.low = minus_one,
                                 .high = one,
                                 .low_transmission = std::numbers::pi,
                                 .high_transmission = 0.0};
}

DriveCurve::Range DriveCurve::range() const {
  switch (argument_) {
    case Argument::cosine:
      return range_of_angle();
    case Argument::square:
      return range_of_square();
    case Argument::linear:
    case Argument::none:
      break;
  }
  return range_of_line();
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
    const Point normal = left_of(output_.direction);
    const double away = dot(normal, input_place - output_.centre_point);
    const double h = std::abs(arm);
    return std::arg(normal) - side * reached_angle(h + away, h - away) - std::arg(arm);
  }
  const Point to_centre = output_.centre_point - input_place;
  const double rho = std::abs(to_centre);
  if (output_.kind == DyadKind::crank) {
    const double h = std::abs(arm);
    const double k = output_.length;
    const double angle =
        reached_angle((k - h + rho) * (k + h - rho), (h + rho - k) * (h + rho + k));
    return std::arg(to_centre) - side * angle - std::arg(arm);
  }
  return std::arg(to_centre) + side * reached_angle(rho + over_root_, rho - over_root_) -
         std::arg(left_of(output_.direction));
}

Pose DriveCurve::pose_of_inverted_input(double x, int side) const {
  Pose pose{.origin = {}, .angle = zero_ + x};
  const Point along = unit_vector(pose.angle) * input_.direction;
  const Point normal = left_of(along);
  const double offset = dot(left_of(input_.direction), output_.circle_point - input_.circle_point);
  if (output_.kind == DyadKind::crank) {
    const Offset at = offset_of(x);
    const Point arm = unit_vector(side * reached_angle(below_one(at), above_minus_one(at)));
    const Point place =
        output_.centre_point - output_.length * (arm.real() * normal + arm.imag() * along);
    pose.origin = place - unit_vector(pose.angle) * output_.circle_point;
    return pose;
  }
  // The line along which the output's circle point is led, cut with what the output asks for.
  const Point place = input_.centre_point + offset * normal;
  const Point line = left_of(output_.direction);
  const Point other_normal =
      output_.kind == DyadKind::slider ? line : unit_vector(pose.angle) * line;
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
