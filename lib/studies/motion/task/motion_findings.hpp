// What became of a finite motion, as diagnostics.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// Whether what the plan asks for can be answered: quantities that need a case, or its input and
/// output. False iff an error was added.
bool check_report(const MotionPlan& plan, const Mechanism& mechanism, Diagnostics& found);

/// Couplings that cannot be moved: E0507. False iff there are any.
bool check_movable(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found);

/// Ranges of drives that would take hours: E0305. False iff there are any.
bool check_ranges(const FoundMotion& motion, const Mechanism& mechanism, Diagnostics& found);

/// What stopped the motion, and what it passed.
void add_motion_findings(const FoundMotion& motion,
                         const MechanismDescription& description,
                         const Mechanism& mechanism,
                         Diagnostics& found);

}  // namespace kinestat
