// What a motion with inertia tells as a whole, for people.
#pragma once

#include "report/text_blocks.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// Flywheel, harmonics, counterweights and limit speeds, each with a heading; nothing of a motion
/// of which none is asked.
TextBlocks motion_dynamics_blocks(const MotionTable& motion);

}  // namespace kinestat
