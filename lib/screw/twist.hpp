// Twist (pt: heligiro): the instantaneous motion of one body relative to another.
#pragma once

#include <cmath>

#include "core/tolerance.hpp"
#include "core/types.hpp"
#include "math/numbers/dual.hpp"
#include "screw/local_origin.hpp"

namespace kinestat {

/// ω [rad/s] and v_O [m/s], the velocity of the point of the body that is at the origin: that of
/// the mechanism (LocalOrigin), unless its name says world.
/// The sources call this order axial; other authors swap the halves.
template <class Scalar>
struct TwistOf {
  Vec3Of<Scalar> angular = Vec3Of<Scalar>::Zero();
  Vec3Of<Scalar> linear = Vec3Of<Scalar>::Zero();

  /// [ω; v_O]
  Vec6Of<Scalar> coordinates() const {
    Vec6Of<Scalar> result;
    result << angular, linear;
    return result;
  }

  static TwistOf from_coordinates(const Vec6Of<Scalar>& c) {
    return {.angular = c.template head<3>(), .linear = c.template tail<3>()};
  }

  friend TwistOf operator+(const TwistOf& a, const TwistOf& b) {
    return {.angular = a.angular + b.angular, .linear = a.linear + b.linear};
  }

  friend TwistOf operator-(const TwistOf& a, const TwistOf& b) {
    return {.angular = a.angular - b.angular, .linear = a.linear - b.linear};
  }

  friend TwistOf operator*(const Scalar& rate, const TwistOf& unit) {
    return {.angular = rate * unit.angular, .linear = rate * unit.linear};
  }
};

using Twist = TwistOf<double>;

/// p x s, in which a component that is mere rounding of its two terms is zero: so a line through
/// the origin has no moment about it, however its point was computed. Derivatives stay.
template <class Scalar = double>
Vec3Of<Scalar> moment_of_line(const Vec3In<Scalar>& point, const Vec3In<Scalar>& direction) {
  Vec3Of<Scalar> moment;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const Scalar plus = point[j] * direction[k];
    const Scalar minus = point[k] * direction[j];
    const Scalar difference = plus - minus;
    const double size = std::abs(value_of(plus)) + std::abs(value_of(minus));
    const double value = value_of(difference);
    moment[i] = std::abs(value) <= kCancellation * size ? difference - Scalar(value) : difference;
  }
  return moment;
}

/// Unit rotation about the line through `point` along the unit vector `axis`: [s; p x s]
/// (Cazangi 2008, eq. 3.9). Times rad/s.
template <class Scalar = double>
TwistOf<Scalar> unit_rotation(const Vec3In<Scalar>& axis, const Vec3In<Scalar>& point) {
  return {.angular = axis, .linear = moment_of_line<Scalar>(point, axis)};
}

/// Unit translation along the unit vector `direction`: [0; s]. Times m/s.
template <class Scalar = double>
TwistOf<Scalar> unit_translation(const Vec3In<Scalar>& direction) {
  return {.angular = Vec3Of<Scalar>::Zero(), .linear = direction};
}

/// Velocity of the body's point at `point`: V = v_O + ω x p [m/s] (Cazangi 2008, 4.4.1, p. 84).
template <class Scalar>
Vec3Of<Scalar> velocity_at(const TwistOf<Scalar>& twist, const Vec3In<Scalar>& point) {
  return twist.linear + twist.angular.cross(point);
}

/// The same motion written about the world origin, given about `origin`: v_O = v - ω x origin.
template <class Scalar>
TwistOf<Scalar> about_world(const TwistOf<Scalar>& twist, const LocalOrigin& origin) {
  const Vec3Of<Scalar> world = (-origin.place()).template cast<Scalar>();
  return {.angular = twist.angular, .linear = velocity_at<Scalar>(twist, world)};
}

}  // namespace kinestat
