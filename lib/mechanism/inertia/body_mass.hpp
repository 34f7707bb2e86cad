// Mass and inertia of a body as it is drawn.
#pragma once

#include <optional>

#include "core/source.hpp"
#include "core/types.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// Mass and inertia of a body in the drawn position, in the axes of the world. Places are measured
/// from the origin of the Geometry. A body for which the file gives nothing has neither mass nor
/// inertia. In a planar mechanism only the last entry of the tensor counts.
struct BodyMass {
  double mass = 0.0;               ///< [kg]
  Vec3 centre = Vec3::Zero();      ///< of mass [m]
  Mat3 inertia = Mat3::Zero();     ///< tensor about the centre of mass, Jxy = -∫xy dm [kg·m²]
  bool has_inertia = false;        ///< whether the file gives the inertia, even as zero
  std::optional<Vec3> polar_axis;  ///< unit vector: the only axis about which a rotor turns
  int count = 1;      ///< number of equal planets that are drawn as this body; mass and
                      ///< inertia are those of one planet
  SourceRange where;  ///< of the mass, else of the inertia

  bool counts() const { return mass > 0.0 || has_inertia; }
};

}  // namespace kinestat
