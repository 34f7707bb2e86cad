// Whether the actions of a coupling do no work on its freedoms.
#pragma once

#include <vector>

#include "couplings/coupling_geometry.hpp"

namespace kinestat {

/// The largest power of a unit constraint on a unit freedom, lengths counted in `length` [m]; zero
/// for a coupling that is reciprocal.
double reciprocity_error(const CouplingScrews& screws, double length);

/// Sets `breaks` of each parameter that makes a constraint work on a freedom when it moves alone: a
/// coupling of given screws that are reciprocal only together is no coupling beside these values.
void find_breaking_parameters(const CouplingScrewsOf<Dual>& screws, std::vector<bool>& breaks);

}  // namespace kinestat
