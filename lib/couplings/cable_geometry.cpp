#include "couplings/cable_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

template <class Scalar>
using Station = CableStationGeometryOf<Scalar>;

// Two stations with one axis: a point, given or on a body, is a circle of no radius.
template <class Scalar>
struct Circles {
  Vec3Of<Scalar> centre_a;
  Vec3Of<Scalar> centre_b;
  Vec3Of<Scalar> axis = Vec3Of<Scalar>::UnitZ();
  Scalar radius_a = 0.0;  ///< signed, about `axis`
  Scalar radius_b = 0.0;
};

template <class Scalar>
bool is_wrapped(const Station<Scalar>& station) {
  return !station.meets && value_of(station.radius) != 0.0;
}

template <class Scalar>
Circles<Scalar> circles_of(const Station<Scalar>& a, const Station<Scalar>& b) {
  Circles<Scalar> result;
  result.centre_a = a.leaves.value_or(a.centre);
  result.centre_b = b.meets.value_or(b.centre);
  if (is_wrapped(a)) {
    result.axis = a.axis;
    result.radius_a = a.radius;
  }
  if (is_wrapped(b)) {
    const bool is_reversed =
        is_wrapped(a) && values_of<Scalar>(a.axis).dot(values_of<Scalar>(b.axis)) < 0.0;
    result.axis = is_wrapped(a) ? a.axis : b.axis;
    result.radius_b = is_reversed ? -b.radius : b.radius;
  }
  return result;
}

// The angle of v against u about n, from -π to π.
template <class Scalar>
Scalar angle_about(const Vec3Of<Scalar>& n, const Vec3Of<Scalar>& u, const Vec3Of<Scalar>& v) {
  using std::atan2;
  const Vec3Of<Scalar> across = u.cross(v);
  return atan2(across.dot(n), u.dot(v));
}

}  // namespace

SpanFault find_fault(const CableStationGeometry& a, const CableStationGeometry& b) {
  const Circles<double> circles = circles_of<double>(a, b);
  const Vec3 c = circles.centre_b - circles.centre_a;
  const double size = std::max(c.norm(), circles.centre_a.norm());
  if (!is_wrapped(a) && !is_wrapped(b)) {
    return c.norm() <= kSameValue * size ? SpanFault::same_point : SpanFault::none;
  }
  const bool has_two_axes = is_wrapped(a) && is_wrapped(b);
  const double radius = std::max(std::abs(circles.radius_a), std::abs(circles.radius_b));
  if ((has_two_axes && a.axis.cross(b.axis).norm() > kParallelAxes) ||
      std::abs(c.dot(circles.axis)) > kParallelAxes * std::max(c.norm(), radius)) {
    return SpanFault::out_of_plane;
  }
  const double s = circles.radius_b - circles.radius_a;
  if (c.squaredNorm() - s * s > kSameValue * s * s) {
    return SpanFault::none;
  }
  if (!has_two_axes) {
    return SpanFault::point_inside;
  }
  return circles.radius_a * circles.radius_b > 0.0 ? SpanFault::circle_inside : SpanFault::overlap;
}

template <class Scalar>
CableSpanOf<Scalar> tangent_span(const Station<Scalar>& a, const Station<Scalar>& b) {
  using std::sqrt;
  const Circles<Scalar> circles = circles_of<Scalar>(a, b);
  if (!is_wrapped(a) && !is_wrapped(b)) {
    return {.from = circles.centre_a, .to = circles.centre_b};
  }
  // On a circle the cable moves along u where it is at ρ u x n from the centre. The centres are
  // c = L u - s u x n apart; solved for u and u x n.
  const Vec3Of<Scalar> c = circles.centre_b - circles.centre_a;
  const Vec3Of<Scalar> across = c.cross(circles.axis);
  const Scalar c2 = c.squaredNorm();
  const Scalar s = circles.radius_b - circles.radius_a;
  const Scalar length = sqrt(c2 - s * s);
  Vec3Of<Scalar> outward;  // u x n
  for (Eigen::Index i = 0; i < 3; ++i) {
    outward[i] = (length * across[i] - s * c[i]) / c2;
  }
  return {.from = circles.centre_a + circles.radius_a * outward,
          .to = circles.centre_b + circles.radius_b * outward};
}

template <class Scalar>
Vec3Of<Scalar> along_segment(const Vec3Of<Scalar>& from, const Vec3Of<Scalar>& to) {
  Vec3Of<Scalar> along = to - from;
  if constexpr (!std::same_as<Scalar, ExactInput>) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double bound =
          kCancellation * (std::abs(value_of(from[i])) + std::abs(value_of(to[i])));
      const double value = value_of(along[i]);
      along[i] -= Scalar(value - zero_within_bound(value, bound));
    }
  }
  return along;
}

template <class Scalar>
Scalar wrap_angle(const Station<Scalar>& pulley,
                  const CableSpanOf<Scalar>& arrives,
                  const CableSpanOf<Scalar>& leaves) {
  const Scalar angle =
      angle_about<Scalar>(pulley.axis, arrives.to - arrives.from, leaves.to - leaves.from);
  const Scalar theta = value_of(pulley.radius) < 0.0 ? -angle : angle;
  if (value_of(theta) >= 0.0) {
    return theta;
  }
  // A cable that runs straight past must not become a whole turn by rounding.
  const bool is_straight = value_of(theta) >= -kSameValue;
  return is_straight ? theta - Scalar(value_of(theta)) : theta + Scalar(2.0 * std::numbers::pi);
}

bool crosses_itself(double radius, double angle, double shorter) {
  constexpr double kHalfTurn = std::numbers::pi;
  return angle >= 2.0 * kHalfTurn ||
         (angle > kHalfTurn && std::abs(radius * std::tan(angle / 2.0)) < shorter);
}

bool passes_through(const CableSpan& span, const CableStationGeometry& pulley, double margin) {
  const Vec3 along = span.to - span.from;
  const Vec3 arm = pulley.centre - span.from;
  const double radius = std::abs(pulley.radius);
  const double reach = std::max({along.norm(), arm.norm(), radius});
  if (std::abs(arm.dot(pulley.axis)) > kParallelAxes * reach ||
      std::abs(along.dot(pulley.axis)) > kParallelAxes * reach) {
    return false;
  }
  const double foot = std::clamp(arm.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (arm - foot * along).norm() < radius * (1.0 - margin);
}

template CableSpan tangent_span(const CableStationGeometry&, const CableStationGeometry&);
template CableSpanOf<Dual> tangent_span(const Station<Dual>&, const Station<Dual>&);
template Vec3 along_segment(const Vec3&, const Vec3&);
template Vec3Of<Dual> along_segment(const Vec3Of<Dual>&, const Vec3Of<Dual>&);
template Vec3Of<ExactInput> along_segment(const Vec3Of<ExactInput>&, const Vec3Of<ExactInput>&);
template double wrap_angle(const CableStationGeometry&, const CableSpan&, const CableSpan&);
template Dual wrap_angle(const Station<Dual>&, const CableSpanOf<Dual>&, const CableSpanOf<Dual>&);
template CableSpanOf<ExactInput> tangent_span(const Station<ExactInput>&,
                                              const Station<ExactInput>&);

}  // namespace kinestat
