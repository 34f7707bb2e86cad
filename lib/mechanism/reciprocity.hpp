// Whether the actions of a coupling do no work on its freedoms.
#pragma once

#include "mechanism/coupling_geometry.hpp"

namespace kinestat {

/// The largest power of a unit constraint on a unit freedom, lengths counted in `length` [m]; zero
/// for a coupling that is reciprocal.
double reciprocity_error(const CouplingScrews& screws, double length);

}  // namespace kinestat
