// Derivatives of the geometry that are rounding of others.
#pragma once

#include <cstddef>

#include "math/numbers/dual_vector.hpp"
#include "mechanism/geometry.hpp"

namespace kinestat {

/// Sets every derivative of a coordinate of a screw to zero that is below kCancellation of the
/// steepest one by the same parameter, lengths counted in those of the geometry. A coordinate that
/// should stand still would otherwise move redundant couplings apart.
void drop_rounding(GeometryOf<Dual>& geometry, std::size_t parameter_count);

}  // namespace kinestat
