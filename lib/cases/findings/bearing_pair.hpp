// Two bearings of one shaft that together bear more than equilibrium determines.
#pragma once

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A hint what two bearings of one shaft should carry as a locating and a floating bearing. Empty
/// if that would remove none of the open actions. `open` are indices of actions.
std::string bearing_pair_hint(const Mechanism& mechanism, const std::vector<int>& open);

}  // namespace kinestat
