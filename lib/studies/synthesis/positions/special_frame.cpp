#include "studies/synthesis/positions/special_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/tolerance.hpp"
#include "studies/synthesis/dyads/bounded_point.hpp"
#include "studies/synthesis/positions/internal/jets_by_angle.hpp"

namespace kinestat {

namespace {

// i^k.
template <class Scalar = double>
PointOf<Scalar> quarter_turns(std::size_t k) {
  constexpr int kCosines[] = {1, 0, -1, 0};
  return PointOf<Scalar>(Scalar(kCosines[k % 4]), Scalar(kCosines[(k + 3) % 4]));
}

template <class Scalar>
PointOf<Scalar> turned_by(const Scalar& angle) {
  using std::cos;
  using std::sin;
  return PointOf<Scalar>(cos(angle), sin(angle));
}

bool is_within_reach(const Point& point) {
  return std::abs(point) <= kLargestNumber;
}

// o' = i (o - P) γ'.
BoundedPoint bounded_pole(const PositionJets& position) {
  const BoundedPoint slope = BoundedPoint::written(origin(position, 1));
  const BoundedNumber turn = written(position.angle[1]);
  return BoundedPoint::written(origin(position)) +
         BoundedPoint{.x = exactly(0.0) - slope.y / turn, .y = slope.x / turn};
}

// The place and its derivatives by the angle.
std::vector<BoundedPoint> bounded_jets_by_angle(const PositionJets& position) {
  std::vector<BoundedNumber> x;
  std::vector<BoundedNumber> y;
  std::vector<BoundedNumber> speed;
  for (int k = 0; k < position.order(); ++k) {
    const BoundedPoint one = BoundedPoint::written(origin(position, k));
    x.push_back(one.x);
    y.push_back(one.y);
    if (k > 0) {
      speed.push_back(written(position.angle[static_cast<std::size_t>(k)]));
    }
  }
  x = jets_by_angle(std::move(x), speed);
  y = jets_by_angle(std::move(y), speed);
  std::vector<BoundedPoint> jets;
  for (std::size_t k = 0; k < x.size(); ++k) {
    jets.push_back({.x = x[k], .y = y[k]});
  }
  return jets;
}

// From the pole to the inflection pole, i d e^{iθ}.
BoundedPoint turned_diameter(const SpecialFrame& frame) {
  const Point turned = unit_vector(frame.angle) * Point(0.0, frame.diameter);
  return BoundedPoint::within(turned, frame.bounds.turned_diameter) +
         BoundedPoint::within({0.0, 0.0}, BoundedPoint::written(turned).bound());
}

// e^{iθ}.
BoundedPoint turn_of(const SpecialFrame& frame) {
  const Point bound = frame.bounds.turned_diameter;
  const double share = frame.diameter > 0.0
                           ? std::max(bound.real(), bound.imag()) / frame.diameter + kDataRounding
                           : 0.0;
  return BoundedPoint::within(unit_vector(frame.angle), {share, share});
}

BoundedPoint derivative_of(const SpecialFrame& frame, std::size_t k) {
  return k < frame.bounds.derivatives.size()
             ? BoundedPoint::within(frame.derivatives[k], frame.bounds.derivatives[k])
             : BoundedPoint::written(frame.derivatives[k]);
}

// Of what the special frame places `along` diameters from the pole along the pole normal.
Circle circle_of(const SpecialFrame& frame, double along) {
  const BoundedPoint centre =
      BoundedPoint::within(frame.pole, frame.bounds.pole) + exactly(along) * turned_diameter(frame);
  return {.centre = centre.zeroed(), .radius = frame.diameter / 2};
}

// What rounding leaves where a sum of terms of that size should be zero is zero.
template <class Scalar>
Scalar without_rounding(const Scalar& sum, const Scalar& size) {
  using std::abs;
  return abs(sum) <= sum_rounding<Scalar>() * size ? Scalar(0) : sum;
}

}  // namespace

template <class Scalar>
PointOf<Scalar> SpecialFrameOf<Scalar>::from_fixed(const PointOf<Scalar>& point) const {
  return turned_by(Scalar(-angle)) * (point - pole);
}

std::optional<Point> find_pole(const PositionJets& position) {
  if (position.order() < 2 || position.angle[1] == 0.0) {
    return std::nullopt;
  }
  const Point pole = bounded_pole(position).zeroed();
  return is_within_reach(pole) ? std::optional(pole) : std::nullopt;
}

std::optional<SpecialFrame> find_special_frame(const PositionJets& position) {
  const std::optional<Point> pole = find_pole(position);
  if (!pole || position.order() < 3) {
    return std::nullopt;
  }
  const BoundedPoint sure_pole = bounded_pole(position);
  const std::vector<BoundedPoint> jets = bounded_jets_by_angle(position);
  // The inflection pole is J = o + o''.
  const BoundedPoint to_inflection = jets[0] + jets[2] - sure_pole;
  const Point diameter = to_inflection.zeroed();
  SpecialFrame frame{.pole = *pole, .diameter = std::abs(diameter)};
  frame.bounds.pole = sure_pole.bound();
  frame.bounds.turned_diameter = to_inflection.bound();
  frame.angle = frame.diameter > 0.0 ? std::atan2(-diameter.real(), diameter.imag()) : 0.0;
  const BoundedPoint turn_back = conj(turn_of(frame));
  const BoundedPoint arm = jets[0] - sure_pole;
  for (std::size_t k = 0; k < jets.size(); ++k) {
    const Point quarter = quarter_turns(k);
    const BoundedPoint of_pole = jets[k] - BoundedPoint::within(quarter, {0.0, 0.0}) * arm;
    const BoundedPoint in_frame = turn_back * of_pole;
    frame.derivatives.push_back(in_frame.zeroed());
    frame.bounds.derivatives.push_back(in_frame.bound());
  }
  // What holds by the choice of the frame holds exactly.
  frame.derivatives[0] = Point(0.0, 0.0);
  frame.derivatives[1] = Point(0.0, 0.0);
  frame.derivatives[2] = Point(0.0, frame.diameter);
  return std::ranges::all_of(frame.derivatives, is_within_reach) ? std::optional(frame)
                                                                 : std::nullopt;
}

template <class Scalar>
PositionJetsOf<Scalar> jets_of(const SpecialFrameOf<Scalar>& frame,
                               const PointOf<Scalar>& at,
                               const Scalar& angle) {
  const std::size_t order = frame.derivatives.size();
  PositionJetsOf<Scalar> position{
      .x = {at.real()}, .y = {at.imag()}, .angle = std::vector<Scalar>(order, Scalar(0))};
  for (std::size_t k = 1; k < order; ++k) {
    const PointOf<Scalar> jet = turned_by(frame.angle) * frame.derivatives[k] +
                                quarter_turns<Scalar>(k) * (at - frame.pole);
    const Scalar size = Scalar(abs(frame.derivatives[k])) + abs(at) + abs(frame.pole);
    position.x.push_back(without_rounding<Scalar>(jet.real(), size));
    position.y.push_back(without_rounding<Scalar>(jet.imag(), size));
  }
  position.angle[0] = angle;
  position.angle[1] = Scalar(1);
  return position;
}

template struct SpecialFrameOf<double>;
template struct SpecialFrameOf<BigFloat>;
template PositionJets jets_of(const SpecialFrame&, const Point&, const double&);
template PositionJetsOf<BigFloat> jets_of(const SpecialFrameOf<BigFloat>&,
                                          const PrecisePoint&,
                                          const BigFloat&);

Circle inflection_circle(const SpecialFrame& frame) {
  return circle_of(frame, 0.5);
}

Circle cuspidal_circle(const SpecialFrame& frame) {
  return circle_of(frame, -0.5);
}

std::optional<StationaryCurvature> find_stationary_curvature(const SpecialFrame& frame) {
  const double d = frame.diameter;
  if (frame.derivatives.size() < 4 || !(d > 0.0)) {
    return std::nullopt;
  }
  // α3 = 3 d²/M - 3 d, β3 = 3 d²/N; do Valle 1983, eqs. 2.41 to 2.45.
  const Point off = frame.bounds.turned_diameter;
  const BoundedNumber sure_d = {.value = d, .bound = std::hypot(off.real(), off.imag())};
  const BoundedPoint third = derivative_of(frame, 3);
  const BoundedNumber triple = exactly(3.0) * sure_d;
  return StationaryCurvature{.inverse_m = ((third.x / sure_d + exactly(3.0)) / triple).zeroed(),
                             .inverse_n = (third.y / sure_d / triple).zeroed()};
}

std::optional<Point> find_ball_point(const SpecialFrame& frame) {
  if (frame.derivatives.size() < 4) {
    return std::nullopt;
  }
  const BoundedPoint third = derivative_of(frame, 3);
  const BoundedNumber square = dot(third, third);
  if (third.zeroed() == Point(0.0, 0.0)) {
    return std::nullopt;
  }
  // On the inflection circle in the direction tan φ = -α3/β3.
  const BoundedNumber share = third.x / square;
  const BoundedPoint along = {.x = share * third.x, .y = share * third.y};
  return (BoundedPoint::within(frame.pole, frame.bounds.pole) + along * turned_diameter(frame))
      .zeroed();
}

}  // namespace kinestat
