// The inertia of a body where it stands, and what it does.
#pragma once

#include "mechanism/inertia/body_mass.hpp"
#include "mechanism/inertia/mass_numbers.hpp"
#include "screw/bounded_screw.hpp"
#include "screw/pose.hpp"
#include "studies/motion/state_bounds.hpp"

namespace kinestat {

/// Axes of the world, points and screws from the origin of the Geometry; of planets all of them
/// together, as if they stood where the one is drawn.
using BodyInertia = MassNumbersOf<double>;

/// In a position: the drawn one moved by the pose.
BodyInertia inertia_at(const BodyMass& drawn, const BodyPose& pose);

/// Of the centre [m/s²]: the twist and its time derivative are about the origin.
template <class Scalar>
Vec3Of<Scalar> centre_acceleration(const MassNumbersOf<Scalar>& body,
                                   const TwistOf<Scalar>& twist,
                                   const TwistOf<Scalar>& twist_rate) {
  return velocity_at<Scalar>(twist_rate, body.centre) +
         twist.angular.cross(velocity_at<Scalar>(twist, body.centre));
}

/// D'Alembert's force -m a at the centre and couple -(J α + ω x J ω), about the origin.
template <class Scalar>
WrenchOf<Scalar> inertial_wrench(const MassNumbersOf<Scalar>& body,
                                 const TwistOf<Scalar>& twist,
                                 const TwistOf<Scalar>& twist_rate) {
  const Vec3Of<Scalar> force = -body.mass * centre_acceleration(body, twist, twist_rate);
  const Vec3Of<Scalar> spin = body.tensor * twist.angular;
  const Vec3Of<Scalar> couple = -(body.tensor * twist_rate.angular + twist.angular.cross(spin));
  return {.moment = body.centre.cross(force) + couple, .force = force};
}

/// About the origin: angular momentum [kg·m²/s] as moment, momentum [kg·m/s] as force
/// (Featherstone 2008, section 2.12).
Wrench momentum(const BodyInertia& body, const Twist& twist);

/// Likewise; its power is the rate at which the kinetic energy falls. `bounds` say how far the
/// motion may be off.
BoundedWrench inertial_wrench(const BodyInertia& body,
                              const Twist& twist,
                              const Twist& twist_rate,
                              const BodyBounds& bounds);

/// Components that are mere rounding become zero, as `bounds` of the state has it for
/// accelerations; the others stay as they are.
Wrench settled(const BoundedWrench& acts, const BodyInertia& body, const StateBounds& bounds);

/// Of a motion that may be off by `bounds`.
BoundedWrench momentum(const BodyInertia& body, const Twist& twist, const BodyBounds& bounds);

/// [J]
double kinetic_energy(const BodyInertia& body, const Twist& twist);

/// The momentum of the first motion as power on the second, which is that of the second on the
/// first: an entry of the mass matrix where they are those of unit rates.
double shared_inertia(const BodyInertia& body, const Twist& first, const Twist& second);

}  // namespace kinestat
