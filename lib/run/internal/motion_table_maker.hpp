// From the positions of a motion to its table, in the units of the file.
#pragma once

#include "report/motion_table.hpp"
#include "run/internal/found_motion.hpp"
#include "run/internal/position_findings.hpp"

namespace kinestat {

/// The table of what was found. What there is to say of its rows is added to `found`.
MotionTable make_motion_table(const MechanismDescription& description,
                              const Mechanism& mechanism,
                              const FoundMotion& motion,
                              PositionFindings& found);

}  // namespace kinestat
