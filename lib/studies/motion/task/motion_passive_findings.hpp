// Which positions of a motion its drives leave open.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// W0506, once: bodies that turn or shift without any other feeling it, where the report has
/// positions that show it, or velocities that neither the drives nor the case determine.
void add_motion_passive_findings(const FoundMotion& motion,
                                 const Mechanism& mechanism,
                                 Diagnostics& found);

}  // namespace kinestat
