// The catalogue of couplings: which unit motions each type frees and which unit actions it bears.
#pragma once

#include <string>
#include <vector>

#include "description/coupling_description.hpp"
#include "screw/wrench.hpp"

namespace kinestat {

/// A direction as it was written: along a world axis (then names are "wz", "Tx", …) or a vector
/// (then "w", "T1", …).
struct Axis {
  Vec3 direction = Vec3::UnitZ();  ///< unit vector, sign included
  char keyword = 'z';              ///< 'x', 'y', 'z', or 0 for a vector
};

/// The numbers of one coupling in SI units.
struct CouplingGeometry {
  Vec3 at = Vec3::Zero();
  Axis axis;
  Vec3 line_of_action = Vec3::UnitX();  ///< of a gear: unit direction of the force of tail on head
};

struct NamedTwist {
  std::string name;
  bool is_rotation = true;
  Twist screw;
};

struct NamedWrench {
  std::string name;
  bool is_couple = true;
  Wrench screw;
};

/// What a coupling frees and bears; in planar space only wz, vx, vy and Tz, Fx, Fy occur.
struct CouplingScrews {
  std::vector<NamedTwist> freedoms;
  std::vector<NamedWrench> constraints;
};

/// Whether the catalogue has a row for the type yet.
bool is_in_catalogue(CouplingType type);

/// The row of the catalogue; the type must have one. Freedoms and constraints are mutually
/// reciprocal, and f + c = λ except: gear (a rolling pair in kinematics, one force in statics;
/// Cazangi 2008, Tab. 5.4) and clutch and brake (no passive constraint). Names: couples
/// perpendicular to a vector axis a are T1 along t1 = normalised(k - (k·a)a), k the first of x, y,
/// z with the least |k·a|, and T2 along a x t1; forces of a prismatic coupling likewise R1, R2. In
/// the plane the one force across a vector axis is R, along z x a.
CouplingScrews coupling_screws(CouplingType type, Space space, const CouplingGeometry& geometry);

/// The action that an actuator internalises on a freedom: the couple about the axis of a rotation,
/// the force along a translation, through `at`.
NamedWrench internal_action(const NamedTwist& freedom, const Vec3& at);

}  // namespace kinestat
