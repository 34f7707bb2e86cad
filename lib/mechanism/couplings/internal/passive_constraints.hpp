// The constraints that a coupling keeps of those that its type bears.
#pragma once

#include "core/diagnostic.hpp"
#include "couplings/coupling_geometry.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

/// Keeps only the constraints that `passive:` names; complains about names that the coupling does
/// not have.
void keep_passive(const CouplingDescription& coupling, CouplingScrews& screws, Diagnostics& found);

}  // namespace kinestat
