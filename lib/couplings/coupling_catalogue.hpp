// The catalogue of couplings: which unit motions each type frees and which unit actions it bears.
#pragma once

#include "couplings/coupling_geometry.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

/// The row of the catalogue. Freedoms and constraints are mutually reciprocal, and f + c = λ
/// except:
/// - gear, bevel_gear, worm, rack: one relative motion in kinematics and one force in statics
///   (Cazangi 2008, Tab. 5.4); the contact of teeth (is_contact) is a whole point contact;
/// - clutch and brake: no passive constraint;
/// - screws: as listed; where only one side is listed, the other is its reciprocal complement.
///
/// Names. Along a world axis they carry its letter: wz, vx, Rx, Ty. Along a vector a: rotation w,
/// translation v, force R, couple T; perpendicular to it R1, T1, v1 along t1 = normalised(k -
/// (k·a)a), k the first of x, y, z with the least |k·a|, and R2, T2, v2 along a x t1. In the plane
/// the one direction across a vector axis is z x a, without a number. Forces at a point are Rx Ry
/// Rz. Several alike are numbered: w1 w2. A helical turns by w and bears Ra, a wrench of pitch -h
/// along its axis; the force of teeth is Rc, the tension of a cable F.
///
/// A pin in a slot exists in the plane; in space it keeps its pin's axis along z.
/// `Scalar` is double or Dual.
template <class Scalar>
CouplingScrewsOf<Scalar> coupling_screws(CouplingType type,
                                         Space space,
                                         const CouplingGeometryOf<Scalar>& geometry);

/// The action that an actuator internalises on a freedom: the couple about the axis of a rotation,
/// the force along a translation, through `at`.
template <class Scalar>
NamedWrenchOf<Scalar> internal_action(const NamedTwistOf<Scalar>& freedom,
                                      const Vec3In<Scalar>& at);

}  // namespace kinestat
