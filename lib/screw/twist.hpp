// Twist (pt: heligiro): the instantaneous motion of one body relative to another.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// ω [rad/s] and v_O [m/s], the velocity of the point of the body that is at the world origin.
/// The sources call this order axial; other authors swap the halves.
struct Twist {
  Vec3 angular = Vec3::Zero();
  Vec3 linear = Vec3::Zero();

  /// [ω; v_O]
  Vec6 coordinates() const {
    Vec6 result;
    result << angular, linear;
    return result;
  }

  static Twist from_coordinates(const Vec6& c) {
    return {.angular = c.head<3>(), .linear = c.tail<3>()};
  }

  friend Twist operator+(const Twist& a, const Twist& b) {
    return {.angular = a.angular + b.angular, .linear = a.linear + b.linear};
  }

  friend Twist operator-(const Twist& a, const Twist& b) {
    return {.angular = a.angular - b.angular, .linear = a.linear - b.linear};
  }

  friend Twist operator*(double rate, const Twist& unit) {
    return {.angular = rate * unit.angular, .linear = rate * unit.linear};
  }
};

/// Unit rotation about the line through `point` along the unit vector `axis`: [s; p x s]
/// (Cazangi 2008, eq. 3.9). Times rad/s.
inline Twist unit_rotation(const Vec3& axis, const Vec3& point) {
  return {.angular = axis, .linear = point.cross(axis)};
}

/// Unit translation along the unit vector `direction`: [0; s]. Times m/s.
inline Twist unit_translation(const Vec3& direction) {
  return {.angular = Vec3::Zero(), .linear = direction};
}

/// Velocity of the body's point at `point`: V = v_O + ω x p [m/s] (Cazangi 2008, section 4.4.1).
inline Vec3 velocity_at(const Twist& twist, const Vec3& point) {
  return twist.linear + twist.angular.cross(point);
}

/// The same motion written about the world origin, given about `origin`: v_O = v - ω x origin.
inline Twist about_world(const Twist& twist, const Vec3& origin) {
  return {.angular = twist.angular, .linear = velocity_at(twist, -origin)};
}

}  // namespace kinestat
