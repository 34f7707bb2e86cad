// From the positions of a motion to its table, in the units of the file.
#pragma once

#include "report/motion_table.hpp"
#include "run/motion.hpp"

namespace kinestat {

/// The table of what was found.
MotionTable make_motion_table(const MechanismDescription& description,
                              const Mechanism& mechanism,
                              const FoundMotion& motion);

}  // namespace kinestat
