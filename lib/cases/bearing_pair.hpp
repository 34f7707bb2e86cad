// Two bearings of one shaft that bear more than equilibrium determines.
#pragma once

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// What they are to carry as a locating and a floating bearing, where that takes away one of the
/// actions that are open; else empty.
std::string bearing_pair_hint(const Mechanism& mechanism, const std::vector<int>& open);

}  // namespace kinestat
