// Why rows of a finite motion have no velocities or accelerations.
#pragma once

#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// Beside what is found of the case in each position; nothing where all rows have what was asked
/// for.
void add_motion_speed_findings(const FoundMotion& motion,
                               const Mechanism& mechanism,
                               Diagnostics& found);

}  // namespace kinestat
