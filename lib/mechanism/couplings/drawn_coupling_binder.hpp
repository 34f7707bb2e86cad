// The couplings of a mechanism as they were drawn, which its screws alone do not tell any more.
#pragma once

#include <vector>

#include "couplings/drawn_coupling.hpp"
#include "description/mechanism_description.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// One a coupling of the topology; `mechanism` must be what bind made of the description.
std::vector<DrawnCoupling> bind_drawn_couplings(const MechanismDescription& description,
                                                const Mechanism& mechanism);

}  // namespace kinestat
