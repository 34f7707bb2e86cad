// Rates of the freedoms of contacts and cables in a moved position.
#pragma once

#include <span>

#include "studies/motion/motion_state.hpp"

namespace kinestat {

/// Gives a state with bounds the rates of the freedoms that have no positions: what a coupling
/// turns and slides, where it touches or pulls now, for the twists of its two bodies. A state
/// without twists stays as it is.
void add_contact_rates(const MotionNetwork& network,
                       std::span<const DrawnCoupling> drawn,
                       const Mechanism& mechanism,
                       MotionState& state);

}  // namespace kinestat
