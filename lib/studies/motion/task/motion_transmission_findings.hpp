// Why a motion has no transmission angle.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// Where one is asked for and no position has it: W0505. At dead points alone it explains itself.
void add_motion_transmission_findings(const FoundMotion& motion,
                                      const Mechanism& mechanism,
                                      Diagnostics& found);

}  // namespace kinestat
