#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/motion/motion_state.hpp"

namespace kinestat {

Vec3 point_position(const MotionState& state,
                    BodyId body,
                    const Vec3& drawn,
                    const LocalOrigin& origin) {
  const std::size_t b = at(body.value);
  const Vec3 position = state.poses[b].point(drawn);
  const Vec3 in_world = origin.in_world(position);
  if (state.bounds.bodies.empty()) {
    return in_world;
  }
  const double bound = position_bound(state.bounds.bodies[b], position, position);
  return in_world.binaryExpr(origin.place(), [&](double x, double shift) {
    return zero_within_bound(x, bound + kEpsilon * std::abs(shift));
  });
}

BoundedRate point_velocity(const MotionState& state, BodyId body, const Vec3& drawn) {
  const std::size_t b = at(body.value);
  if (state.twists.empty()) {
    return {};
  }
  const Vec3 arm = state.poses[b].point(drawn);
  const Vec3 velocity = velocity_at(state.twists[b], arm);
  if (state.bounds.bodies.empty()) {
    return {.value = velocity};
  }
  const double bound = velocity_bound(state.bounds.bodies[b], arm, arm, state.twists[b]);
  const double rounding = state.bounds.rate_rounding * (state.bounds.reach + arm.norm());
  return {.value = settled_rates(velocity, bound, rounding), .bound = bound};
}

BoundedRate point_acceleration(const MotionState& state, BodyId body, const Vec3& drawn) {
  const std::size_t b = at(body.value);
  if (state.twists.empty() || state.twist_rates.empty()) {
    return {};
  }
  const Vec3 arm = state.poses[b].point(drawn);
  const Vec3 acceleration = velocity_at(state.twist_rates[b], arm) +
                            state.twists[b].angular.cross(velocity_at(state.twists[b], arm));
  if (state.bounds.bodies.empty()) {
    return {.value = acceleration};
  }
  const double bound =
      acceleration_bound(state.bounds.bodies[b], arm, arm, state.twists[b], state.twist_rates[b]);
  const double rounding = state.bounds.rate_rate_rounding * (state.bounds.reach + arm.norm());
  return {.value = settled_rates(acceleration, bound, rounding), .bound = bound};
}

}  // namespace kinestat
