#include "motion/state_bounds.hpp"

#include "core/tolerance.hpp"

namespace kinestat {

// v = v₀ + ω × r and a = a₀ + α × r + ω × v, with what each factor may be off.
PointBounds point_bounds(const BodyBounds& body,
                         const Vec3& arm,
                         const Vec3& position,
                         const Twist& twist,
                         const Twist& twist_rate) {
  const double r = arm.norm();
  const double turns = twist.angular.norm();
  const double bends = twist_rate.angular.norm();
  const double speed = twist.linear.norm() + turns * r;
  PointBounds bounds;
  bounds.position = body.shift + body.turn * r + 4.0 * kEpsilon * (r + position.norm());
  bounds.velocity =
      body.linear + body.angular * r + turns * bounds.position + 4.0 * kEpsilon * speed;
  bounds.acceleration = body.linear_rate + body.angular_rate * r + bends * bounds.position +
                        body.angular * speed + turns * bounds.velocity +
                        4.0 * kEpsilon * (twist_rate.linear.norm() + bends * r + turns * speed);
  return bounds;
}

}  // namespace kinestat
