// Reciprocity: the constraints of a coupling do no work on its freedoms.
#pragma once

#include <vector>

#include "couplings/coupling_geometry.hpp"

namespace kinestat {

/// The largest power of a unit constraint on a unit freedom, with `length` [m] as the unit of
/// length. Zero for a reciprocal coupling.
double reciprocity_error(const CouplingScrews& screws, double length);

/// Sets `breaks` for each parameter which, if it changes alone, makes a constraint do work on a
/// freedom. The coupling, whose screws are given, is then reciprocal only at the present values.
void find_breaking_parameters(const CouplingScrewsOf<Dual>& screws, std::vector<bool>& breaks);

}  // namespace kinestat
