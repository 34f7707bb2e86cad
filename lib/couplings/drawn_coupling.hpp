// A coupling as it was drawn.
#pragma once

#include <optional>

#include "couplings/cable_geometry.hpp"
#include "couplings/coupling_geometry.hpp"

namespace kinestat {

/// The shape of a body where it touches another, in the section of the normal.
struct ContactShape {
  double curvature = 0.0;  ///< [1/m] 0: flat; positive: the body is round there; negative: hollow
};

/// World frame, SI. Where the drawing shows the two bodies apart, the point of the geometry is that
/// of the tail.
struct DrawnCoupling {
  CouplingGeometry geometry;
  bool has_place = true;        ///< the file says where it is
  std::optional<Vec3> at_head;  ///< the point as drawn on the head, where it is another [m]
  std::optional<CableStationGeometry> from;  ///< of a segment of a cable: where it leaves
  std::optional<CableStationGeometry> to;    ///< and where it arrives
  std::optional<ContactShape> tail_shape;    ///< of a contact whose profiles the file gives
  std::optional<ContactShape> head_shape;
};

}  // namespace kinestat
