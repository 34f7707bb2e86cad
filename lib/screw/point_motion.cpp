#include "screw/point_motion.hpp"

#include <algorithm>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

double fastest_of(const Twist& twist, const Vec3& velocity, double length) {
  return std::max(twist.angular.norm() * length, velocity.norm());
}

}  // namespace

bool moves_point(const Twist& twist, const Vec3& point, double length) {
  const Vec3 velocity = velocity_at(twist, point);
  return velocity.norm() > kRankZero * fastest_of(twist, velocity, length);
}

bool turns(const Twist& twist, double length) {
  return twist.angular.norm() * length > kRankZero * fastest_of(twist, twist.linear, length);
}

}  // namespace kinestat
