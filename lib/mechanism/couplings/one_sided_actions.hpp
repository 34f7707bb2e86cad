// Actions that bodies can bear in one direction only.
#pragma once

#include <vector>

#include "mechanism/topology.hpp"

namespace kinestat {

/// The tensions of segments (couplings of type cable): negative, the cable would push.
std::vector<int> find_tensions(const Topology& topology);

/// The normal forces of contacts without an actuator: negative, the surfaces would pull.
std::vector<int> find_contact_forces(const Topology& topology);

}  // namespace kinestat
