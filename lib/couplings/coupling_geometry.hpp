// The dimensions of one coupling, and what they make of it: unit motions and unit actions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/screw_description.hpp"
#include "math/numbers/dual_vector.hpp"
#include "screw/wrench.hpp"

namespace kinestat {

/// A direction as it was written: along a world axis (then names are "wz", "Tx", …) or a vector
/// (then "w", "T1", …).
template <class Scalar>
struct AxisOf {
  Vec3Of<Scalar> direction = Vec3Of<Scalar>::UnitZ();  ///< unit vector, sign included
  char keyword = 'z';                                  ///< 'x', 'y', 'z', or 0 for a vector
};

/// A screw that the file gives directly.
template <class Scalar>
struct ScrewGeometryOf {
  ScrewWord kind = ScrewWord::rotation;
  AxisOf<Scalar> direction;
  Vec3Of<Scalar> at = Vec3Of<Scalar>::Zero();  ///< a point of its line [m]; rotation and force only
  Scalar pitch = 0.0;                          ///< [m/rad]; rotation and force only
};

/// The numbers of one coupling in SI units. Each type reads those that it needs. `Scalar` is double
/// or Dual.
template <class Scalar>
struct CouplingGeometryOf {
  Vec3Of<Scalar> at = Vec3Of<Scalar>::Zero();
  AxisOf<Scalar> axis;    ///< of turning or sliding, the normal of a contact, the slot of a pin
  AxisOf<Scalar> second;  ///< of a universal: fixed in the head; of a line contact: the line
  Vec3Of<Scalar> line_of_action =
      Vec3Of<Scalar>::UnitX();                ///< of teeth: unit force of tail on head
  std::optional<Vec3Of<Scalar>> other_flank;  ///< of a mesh whose flank follows from the load: the
                                              ///< line of action where the force is negative
  Scalar pitch = 0.0;                         ///< of a helical [m/rad]
  bool is_contact = false;  ///< of a gear: the contact of the teeth instead of a rolling pair
  Vec3Of<Scalar> from = Vec3Of<Scalar>::Zero();      ///< of a cable: its end on the tail [m]
  Vec3Of<Scalar> to = Vec3Of<Scalar>::UnitX();       ///< of a cable: its end on the head [m]
  std::optional<ScrewGeometryOf<Scalar>> relative;   ///< motion of a bevel gear, worm or rack
  std::vector<ScrewGeometryOf<Scalar>> freedoms;     ///< of type screws
  std::vector<ScrewGeometryOf<Scalar>> constraints;  ///< of type screws
};

using Axis = AxisOf<double>;
using ScrewGeometry = ScrewGeometryOf<double>;
using CouplingGeometry = CouplingGeometryOf<double>;

template <class Scalar>
struct NamedTwistOf {
  std::string name;
  bool is_rotation = true;  ///< magnitudes in rad/s, otherwise m/s
  TwistOf<Scalar> screw;
};

template <class Scalar>
struct NamedWrenchOf {
  std::string name;
  bool is_couple = true;  ///< magnitudes in N·m, otherwise N
  WrenchOf<Scalar> screw;
};

/// What a coupling frees and bears; in planar space only wz, vx, vy and Tz, Fx, Fy occur.
template <class Scalar>
struct CouplingScrewsOf {
  std::vector<NamedTwistOf<Scalar>> freedoms;
  std::vector<NamedWrenchOf<Scalar>> constraints;
};

using NamedTwist = NamedTwistOf<double>;
using NamedWrench = NamedWrenchOf<double>;
using CouplingScrews = CouplingScrewsOf<double>;

}  // namespace kinestat
