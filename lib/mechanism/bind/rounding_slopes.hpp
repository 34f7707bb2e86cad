// Removal of derivatives of the geometry that are only rounding.
#pragma once

#include <cstddef>

#include "math/numbers/dual_vector.hpp"
#include "mechanism/geometry.hpp"

namespace kinestat {

/// Sets to zero every derivative of a coordinate of a screw that is below kCancellation times the
/// largest one with respect to the same parameter; the unit of length is that of the geometry.
/// Otherwise coordinates that should not change would move redundant couplings apart.
void drop_rounding(GeometryOf<Dual>& geometry, std::size_t parameter_count);

}  // namespace kinestat
