// What the statics of the positions of a motion has to say.
#pragma once

#include "core/diagnostic.hpp"
#include "run/motion.hpp"

namespace kinestat {

/// Why there are no actions at positions of a motion that reports them: what an analysis of the
/// first such position says, and at how many it holds; nothing is said of indeterminate positions.
/// And why there is no transmission angle where one is asked for and no position has it: W0505.
void add_motion_statics_findings(const FoundMotion& motion,
                                 const MechanismDescription& description,
                                 const Mechanism& mechanism,
                                 Diagnostics& found);

}  // namespace kinestat
