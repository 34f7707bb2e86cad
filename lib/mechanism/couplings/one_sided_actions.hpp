// Actions that bodies can bear in one direction only.
#pragma once

#include <vector>

#include "mechanism/topology.hpp"

namespace kinestat {

/// Indices of the tensions of segments (couplings of type cable). If one is negative, the cable
/// would have to push.
std::vector<int> find_tensions(const Topology& topology);

/// Indices of the normal forces of contacts without an actuator. If one is negative, the surfaces
/// would have to pull.
std::vector<int> find_contact_forces(const Topology& topology);

}  // namespace kinestat
