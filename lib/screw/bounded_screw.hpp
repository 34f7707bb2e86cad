// Motions and actions with how far they may be off, and what is derived from them.
#pragma once

#include <optional>

#include "math/numbers/bounded_number.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

/// Of a Twist.
struct BoundedTwist {
  BoundedVector angular;
  BoundedVector linear;

  /// What its bounds tell from zero.
  Twist zeroed() const { return {.angular = angular.zeroed(), .linear = linear.zeroed()}; }
};

/// Of a Wrench.
struct BoundedWrench {
  BoundedVector moment;
  BoundedVector force;

  /// What its bounds tell from zero.
  Wrench zeroed() const { return {.moment = moment.zeroed(), .force = force.zeroed()}; }
};

BoundedTwist operator-(const BoundedTwist& a, const BoundedTwist& b);
BoundedWrench operator+(const BoundedWrench& a, const BoundedWrench& b);

/// A unit screw times its magnitude, drawn at `point`, with what rounding did to the drawing: to
/// the direction, and to the arm of the line.
BoundedTwist bounded_screw(const BoundedNumber& rate, const Twist& unit, const Vec3& point);
BoundedWrench bounded_screw(const BoundedNumber& magnitude, const Wrench& unit, const Vec3& point);

/// A twist or wrench that is as exact as the numbers it is written in.
BoundedTwist written(const Twist& twist);
BoundedWrench written(const Wrench& wrench);

/// As those of Twist and Wrench, for a point that is as exact as coordinates are.
BoundedVector velocity_at(const BoundedTwist& twist, const Vec3& point);
BoundedVector moment_at(const BoundedWrench& wrench, const Vec3& point);
BoundedTwist about_world(const BoundedTwist& twist, const LocalOrigin& origin);
BoundedWrench about_world(const BoundedWrench& wrench, const LocalOrigin& origin);
BoundedNumber power(const BoundedWrench& wrench, const BoundedTwist& twist);

/// As of Twist and Wrench: a direction, a place or a pitch that is mere rounding is zero. Empty
/// also where a line is so uncertain that neither its place nor its pitch is known.
std::optional<ScrewAxis> find_axis(const BoundedTwist& twist, double length);
std::optional<ScrewAxis> find_axis(const BoundedWrench& wrench, double length);

}  // namespace kinestat
