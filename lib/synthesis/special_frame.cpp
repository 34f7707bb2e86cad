#include "synthesis/special_frame.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

constexpr Point kI{0.0, 1.0};

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

}  // namespace

template <class Scalar>
PointOf<Scalar> SpecialFrameOf<Scalar>::to_fixed(const PointOf<Scalar>& point) const {
  return pole + turned_by(angle) * point;
}

template <class Scalar>
PointOf<Scalar> SpecialFrameOf<Scalar>::from_fixed(const PointOf<Scalar>& point) const {
  return turned_by(Scalar(-angle)) * (point - pole);
}

std::optional<Point> find_pole(const PositionJets& position) {
  if (position.order() < 2 || position.angle[1] == 0.0) {
    return std::nullopt;
  }
  // o' = i (o - P) γ'.
  const Point pole = origin(position) + kI * origin(position, 1) / position.angle[1];
  return is_within_reach(pole) ? std::optional(pole) : std::nullopt;
}

std::optional<SpecialFrame> find_special_frame(const PositionJets& position) {
  const std::optional<Point> pole = find_pole(position);
  if (!pole || position.order() < 3) {
    return std::nullopt;
  }
  const PositionJets jets = by_angle(position);
  // The inflection pole is J = o + o''.
  const Point diameter = origin(jets) + origin(jets, 2) - *pole;
  SpecialFrame frame{.pole = *pole, .diameter = std::abs(diameter), .derivatives = {}};
  frame.angle = frame.diameter > 0.0 ? std::atan2(-diameter.real(), diameter.imag()) : 0.0;
  const Point arm = origin(jets) - *pole;
  for (int k = 0; k < jets.order(); ++k) {
    const Point of_pole = k == 0
                              ? Point(0.0, 0.0)
                              : origin(jets, k) - quarter_turns(static_cast<std::size_t>(k)) * arm;
    frame.derivatives.push_back(unit_vector(-frame.angle) * of_pole);
  }
  // What holds by the choice of the frame holds exactly.
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
    position.x.push_back(jet.real());
    position.y.push_back(jet.imag());
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
  return {.centre = frame.to_fixed({0.0, frame.diameter / 2}), .radius = frame.diameter / 2};
}

Circle cuspidal_circle(const SpecialFrame& frame) {
  return {.centre = frame.to_fixed({0.0, -frame.diameter / 2}), .radius = frame.diameter / 2};
}

std::optional<StationaryCurvature> find_stationary_curvature(const SpecialFrame& frame) {
  const double d = frame.diameter;
  if (frame.derivatives.size() < 4 || !(d > 0.0)) {
    return std::nullopt;
  }
  // α3 = 3 d²/M - 3 d, β3 = 3 d²/N; do Valle 1983, eqs. 2.41 to 2.45.
  return StationaryCurvature{.inverse_m = (frame.derivatives[3].real() / d + 3.0) / (3.0 * d),
                             .inverse_n = frame.derivatives[3].imag() / d / (3.0 * d)};
}

std::optional<Point> find_ball_point(const SpecialFrame& frame) {
  if (frame.derivatives.size() < 4) {
    return std::nullopt;
  }
  const double a3 = frame.derivatives[3].real();
  const double b3 = frame.derivatives[3].imag();
  const double square = a3 * a3 + b3 * b3;
  if (!(square > 0.0)) {
    return std::nullopt;
  }
  // On the inflection circle in the direction tan φ = -α3/β3.
  return frame.to_fixed(frame.diameter / square * Point(-a3 * b3, a3 * a3));
}

}  // namespace kinestat
