#include "studies/motion/state_bounds.hpp"

#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

double settled_rate(double value, double bound, double rounding) {
  return bound <= rounding ? zero_within_bound(value, bound) : value;
}

Vec3 settled_rates(const Vec3& value, double bound, double rounding) {
  return value.unaryExpr([&](double x) { return settled_rate(x, bound, rounding); });
}

void settle_positions(const StateBounds& bounds, std::vector<std::optional<double>>& positions) {
  for (std::size_t f = 0; f < positions.size(); ++f) {
    if (positions[f]) {
      positions[f] = zero_within_bound(*positions[f], bounds.positions[f]);
    }
  }
}

double position_bound(const BodyBounds& body, const Vec3& arm, const Vec3& position) {
  const double r = arm.norm();
  return body.shift + body.turn * r + 4.0 * kEpsilon * (r + position.norm());
}

// v = v₀ + ω × r, with what each factor may be off.
double velocity_bound(const BodyBounds& body,
                      const Vec3& arm,
                      const Vec3& position,
                      const Twist& twist) {
  const double r = arm.norm();
  const double turns = twist.angular.norm();
  const double speed = twist.linear.norm() + turns * r;
  return body.linear + body.angular * r + turns * position_bound(body, arm, position) +
         4.0 * kEpsilon * speed;
}

// a = a₀ + α × r + ω × v, likewise.
double acceleration_bound(const BodyBounds& body,
                          const Vec3& arm,
                          const Vec3& position,
                          const Twist& twist,
                          const Twist& twist_rate) {
  const double r = arm.norm();
  const double turns = twist.angular.norm();
  const double bends = twist_rate.angular.norm();
  const double speed = twist.linear.norm() + turns * r;
  return body.linear_rate + body.angular_rate * r + bends * position_bound(body, arm, position) +
         body.angular * speed + turns * velocity_bound(body, arm, position, twist) +
         4.0 * kEpsilon * (twist_rate.linear.norm() + bends * r + turns * speed);
}

}  // namespace kinestat
