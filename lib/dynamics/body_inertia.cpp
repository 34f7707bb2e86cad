#include "dynamics/body_inertia.hpp"

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

Wrench of_centre(const BodyInertia& body, const Vec3& force, const Vec3& couple) {
  return {.moment = body.centre.cross(force) + couple, .force = force};
}

}  // namespace

BodyInertia inertia_at(const BodyMass& drawn, const BodyPose& pose) {
  return {.mass = drawn.count * drawn.mass,
          .centre = pose.point(drawn.centre),
          .tensor = drawn.count * (pose.rotation * drawn.inertia * pose.rotation.transpose())};
}

Wrench momentum(const BodyInertia& body, const Twist& twist) {
  return of_centre(body, body.mass * velocity_at(twist, body.centre), body.tensor * twist.angular);
}

BoundedWrench inertial_wrench(const BodyInertia& body,
                              const Twist& twist,
                              const Twist& twist_rate,
                              const BodyBounds& bounds) {
  const Wrench acts = inertial_wrench(body, twist, twist_rate);
  const Vec3& arm = body.centre;
  const double place = position_bound(bounds, arm, arm);
  const double force = body.mass * acceleration_bound(bounds, arm, arm, twist, twist_rate) +
                       4.0 * kEpsilon * acts.force.norm();
  const double turns = twist.angular.norm();
  const double bends = twist_rate.angular.norm();
  const double couple =
      body.tensor.norm() * (bounds.angular_rate + 2.0 * turns * bounds.angular +
                            (2.0 * bounds.turn + 8.0 * kEpsilon) * (bends + turns * turns));
  const double moment = couple + arm.norm() * force + place * acts.force.norm();
  return {.moment = {.value = acts.moment, .bound = Vec3::Constant(moment)},
          .force = {.value = acts.force, .bound = Vec3::Constant(force)}};
}

Wrench settled(const BoundedWrench& acts, const BodyInertia& body, const StateBounds& bounds) {
  const double arm = body.centre.norm();
  const double force = body.mass * bounds.rate_rate_rounding * (bounds.reach + arm);
  const double moment = body.tensor.norm() * bounds.rate_rate_rounding + arm * force;
  return {.moment = settled_rates(acts.moment.value, acts.moment.bound.maxCoeff(), moment),
          .force = settled_rates(acts.force.value, acts.force.bound.maxCoeff(), force)};
}

// What D'Alembert's forces are where a body at rest speeds up so, with the other sign.
BoundedWrench momentum(const BodyInertia& body, const Twist& twist, const BodyBounds& bounds) {
  const BodyBounds speeding_up = {.turn = bounds.turn,
                                  .shift = bounds.shift,
                                  .angular_rate = bounds.angular,
                                  .linear_rate = bounds.linear};
  const BoundedWrench against = inertial_wrench(body, Twist{}, twist, speeding_up);
  return {.moment = {.value = -against.moment.value, .bound = against.moment.bound},
          .force = {.value = -against.force.value, .bound = against.force.bound}};
}

double kinetic_energy(const BodyInertia& body, const Twist& twist) {
  return 0.5 * shared_inertia(body, twist, twist);
}

double shared_inertia(const BodyInertia& body, const Twist& first, const Twist& second) {
  return power(momentum(body, first), second);
}

}  // namespace kinestat
