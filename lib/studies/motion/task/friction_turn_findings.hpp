// Where friction turns round in a finite motion.
#pragma once

#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// W0508, once a coupling: at a dead point its friction has no direction, and just before and
/// behind it two.
void add_friction_turn_findings(const FoundMotion& motion,
                                const Mechanism& mechanism,
                                Diagnostics& found);

}  // namespace kinestat
