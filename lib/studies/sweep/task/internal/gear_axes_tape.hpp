// The axes of gears on the tape of a sweep.
#pragma once

#include <span>

#include "mechanism/bind/rebind.hpp"

namespace kinestat {

/// Demands of the tape that the hinges of each body are on as many lines as in the recorded state,
/// so that each mesh has the carrier that it has there. False where their directions move.
bool demand_same_axes(const Mechanism& mechanism,
                      std::span<const TapedScrew> motions,
                      LaneRecorder& recorder);

}  // namespace kinestat
