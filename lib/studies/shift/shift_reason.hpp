// Why a combination of shift elements is no gear, in words.
#pragma once

#include <span>
#include <string>

#include "mechanism/topology.hpp"
#include "studies/shift/shift_state.hpp"

namespace kinestat {

/// Names what is held, what is left free and which bodies that moves; begins with how many elements
/// are needed if it is not that many. Empty for a gear that leaves nothing free.
std::string reason_of(const Topology& topology,
                      const ShiftNetwork& network,
                      const ShiftPlan& plan,
                      std::span<const int> engaged,
                      const ShiftState& state);

}  // namespace kinestat
