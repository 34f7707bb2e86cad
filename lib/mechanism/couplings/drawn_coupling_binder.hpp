// The couplings of a mechanism as they were drawn; screws alone do not have all of these data.
#pragma once

#include <vector>

#include "couplings/drawn_coupling.hpp"
#include "description/mechanism_description.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Binds one per coupling. `mechanism` must be what bind made of the
/// description.
std::vector<DrawnCoupling> bind_drawn_couplings(const MechanismDescription& description,
                                                const Mechanism& mechanism);

}  // namespace kinestat
