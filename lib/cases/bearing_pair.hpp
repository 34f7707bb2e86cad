// Two bearings of one shaft that bear more than equilibrium determines.
#pragma once

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// "'A' and 'B' are on one axis: passive: [Rx, Ry, Rz] on 'A' and [Rx, Ry] on 'B', …": what makes
/// them a locating and a floating bearing, if an action that this takes away is among the open
/// ones; else empty.
std::string bearing_pair_hint(const Mechanism& mechanism, const std::vector<int>& open);

}  // namespace kinestat
