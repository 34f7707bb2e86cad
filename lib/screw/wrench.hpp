// Wrench (pt: heliforça): the action of one body on another.
#pragma once

#include "screw/twist.hpp"

namespace kinestat {

/// T_O [N·m], the moment about the origin of the mechanism (LocalOrigin), unless its name says
/// world, and F [N]. The sources call this order radial; other authors swap the halves.
template <class Scalar>
struct WrenchOf {
  Vec3Of<Scalar> moment = Vec3Of<Scalar>::Zero();
  Vec3Of<Scalar> force = Vec3Of<Scalar>::Zero();

  /// [T_O; F]
  Vec6Of<Scalar> coordinates() const {
    Vec6Of<Scalar> result;
    result << moment, force;
    return result;
  }

  static WrenchOf from_coordinates(const Vec6Of<Scalar>& c) {
    return {.moment = c.template head<3>(), .force = c.template tail<3>()};
  }

  friend WrenchOf operator+(const WrenchOf& a, const WrenchOf& b) {
    return {.moment = a.moment + b.moment, .force = a.force + b.force};
  }

  friend WrenchOf operator*(const Scalar& magnitude, const WrenchOf& unit) {
    return {.moment = magnitude * unit.moment, .force = magnitude * unit.force};
  }
};

using Wrench = WrenchOf<double>;

/// Unit force along the line through `point` in the unit direction: [p x s; s]
/// (Cazangi 2008, eq. 3.19). Times N.
template <class Scalar = double>
WrenchOf<Scalar> unit_force(const Vec3In<Scalar>& direction, const Vec3In<Scalar>& point) {
  return {.moment = moment_of_line<Scalar>(point, direction), .force = direction};
}

/// Unit couple about the unit direction: [s; 0] (Cazangi 2008, eq. 3.20). Times N·m.
template <class Scalar = double>
WrenchOf<Scalar> unit_couple(const Vec3In<Scalar>& direction) {
  return {.moment = direction, .force = Vec3Of<Scalar>::Zero()};
}

/// Moment about `point`: T = T_O - p x F [N·m] (Cazangi 2008, section 4.4.2, p. 85).
template <class Scalar>
Vec3Of<Scalar> moment_at(const WrenchOf<Scalar>& wrench, const Vec3In<Scalar>& point) {
  return wrench.moment - point.cross(wrench.force);
}

/// The same action written about the world origin, given about `origin`: T_O = T + origin x F.
template <class Scalar>
WrenchOf<Scalar> about_world(const WrenchOf<Scalar>& wrench, const LocalOrigin& origin) {
  const Vec3Of<Scalar> world = (-origin.place()).template cast<Scalar>();
  return {.moment = moment_at<Scalar>(wrench, world), .force = wrench.force};
}

/// Power of an action on a motion [W]; zero means that the two are reciprocal.
template <class Scalar>
Scalar power(const WrenchOf<Scalar>& wrench, const TwistOf<Scalar>& twist) {
  return wrench.moment.dot(twist.angular) + wrench.force.dot(twist.linear);
}

}  // namespace kinestat
