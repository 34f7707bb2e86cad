// Wrench (pt: heliforça): the action of one body on another.
#pragma once

#include "screw/twist.hpp"

namespace kinestat {

/// T_O [N·m], the moment about the world origin, and F [N]. The sources call this order radial;
/// other authors swap the halves.
struct Wrench {
  Vec3 moment = Vec3::Zero();
  Vec3 force = Vec3::Zero();

  /// [T_O; F]
  Vec6 coordinates() const {
    Vec6 result;
    result << moment, force;
    return result;
  }

  static Wrench from_coordinates(const Vec6& c) {
    return {.moment = c.head<3>(), .force = c.tail<3>()};
  }

  friend Wrench operator+(const Wrench& a, const Wrench& b) {
    return {.moment = a.moment + b.moment, .force = a.force + b.force};
  }

  friend Wrench operator*(double magnitude, const Wrench& unit) {
    return {.moment = magnitude * unit.moment, .force = magnitude * unit.force};
  }
};

/// Unit force along the line through `point` in the unit direction: [p x s; s]
/// (Cazangi 2008, eq. 3.19). Times N.
inline Wrench unit_force(const Vec3& direction, const Vec3& point) {
  return {.moment = point.cross(direction), .force = direction};
}

/// Unit couple about the unit direction: [s; 0] (Cazangi 2008, eq. 3.20). Times N·m.
inline Wrench unit_couple(const Vec3& direction) {
  return {.moment = direction, .force = Vec3::Zero()};
}

/// Moment about `point`: T = T_O - p x F [N·m] (Cazangi 2008, section 4.4.2).
inline Vec3 moment_at(const Wrench& wrench, const Vec3& point) {
  return wrench.moment - point.cross(wrench.force);
}

/// The same action written about the world origin, given about `origin`: T_O = T + origin x F.
inline Wrench about_world(const Wrench& wrench, const Vec3& origin) {
  return {.moment = moment_at(wrench, -origin), .force = wrench.force};
}

/// Power of an action on a motion [W]; zero means that the two are reciprocal.
inline double power(const Wrench& wrench, const Twist& twist) {
  return wrench.moment.dot(twist.angular) + wrench.force.dot(twist.linear);
}

}  // namespace kinestat
