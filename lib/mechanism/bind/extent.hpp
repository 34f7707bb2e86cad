// How large a mechanism is and where it stands.
#pragma once

#include <cstddef>
#include <vector>

#include "couplings/coupling_geometry.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

/// In metres.
struct Extent {
  double length = 1.0;         ///< the diagonal of the box around all points; 1 if that is zero
  Vec3 origin = Vec3::Zero();  ///< the world origin; if it is far away, near the centre of the box
};

/// Adds the points that the file gives for a coupling. `Scalar` is double or Dual.
template <class Scalar>
void add_points(const CouplingDescription& coupling,
                const CouplingGeometryOf<Scalar>& geometry,
                std::vector<Vec3Of<Scalar>>& points);

Extent find_extent(const std::vector<Vec3>& points);

/// The length of the extent with its derivatives. They are NaN for a parameter at which it has a
/// corner, as a point leaves others that bound the box with it, or a jump.
Dual find_length(const std::vector<Vec3Of<Dual>>& points, std::size_t parameter_count);

}  // namespace kinestat
