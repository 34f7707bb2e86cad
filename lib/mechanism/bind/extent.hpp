// The size of a mechanism, and an origin near it.
#pragma once

#include <cstddef>
#include <vector>

#include "couplings/coupling_geometry.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

/// The size and the origin of a mechanism [m].
struct Extent {
  double length = 1.0;         ///< the diagonal of the box around all points; 1 if that is zero
  Vec3 origin = Vec3::Zero();  ///< that of the world or, if this is far away, near the box's centre
};

/// Adds the points that the file gives for a coupling. `Scalar` is double or Dual.
template <class Scalar>
void add_points(const CouplingDescription& coupling,
                const CouplingGeometryOf<Scalar>& geometry,
                std::vector<Vec3Of<Scalar>>& points);

Extent find_extent(const std::vector<Vec3>& points);

/// The length of the extent with its derivatives. A derivative is NaN where the length has a corner
/// or a jump, as when one of two points on the same side of the box moves.
Dual find_length(const std::vector<Vec3Of<Dual>>& points, std::size_t parameter_count);

}  // namespace kinestat
