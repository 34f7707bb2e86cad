// From the positions of a motion to its table, in the units of the file.
#pragma once

#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

/// The table of what was found. What there is to say of its rows is added to `found`.
MotionTable make_motion_table(const MechanismDescription& description,
                              const Mechanism& mechanism,
                              const FoundMotion& motion,
                              PositionFindings& found);

}  // namespace kinestat
