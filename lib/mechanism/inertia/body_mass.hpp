// Mass and inertia of a body as it is drawn.
#pragma once

#include <optional>

#include "core/source.hpp"
#include "core/types.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// In the drawn position, from the origin of the Geometry, axes of the world. A body of which the
/// file says nothing has neither mass nor inertia. In the plane only the last entry of the tensor
/// counts.
struct BodyMass {
  double mass = 0.0;           ///< [kg]
  Vec3 centre = Vec3::Zero();  ///< of mass [m]
  Mat3 inertia = Mat3::Zero();  ///< about the centre, entries of the tensor: Jxy = -∫xy dm [kg·m²]
  bool has_inertia = false;     ///< the file gives it, be it zero
  std::optional<Vec3> polar_axis;  ///< unit vector: of a rotor, which turns about it alone
  int count = 1;                   ///< how many equal planets it stands for, of each of which
                                   ///< mass and inertia are one's
  SourceRange where;               ///< of the mass, else of the inertia

  bool counts() const { return mass > 0.0 || has_inertia; }
};

}  // namespace kinestat
