// The finite motion that a description asks for.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

/// Runs the section `motion` of a description that has been bound to this mechanism. What became of
/// it is added to `found`; empty iff there is nothing to report, with an error.
std::optional<FoundMotion> find_motion(const MechanismDescription& description,
                                       const Mechanism& mechanism,
                                       Diagnostics& found);

/// Follows the motion of a plan, whose report is not looked at. Of the result the table is empty;
/// empty iff an error was added: it cannot be moved, or not so far.
std::optional<FoundMotion> follow_motion(const MechanismDescription& description,
                                         const Mechanism& mechanism,
                                         MotionPlan plan,
                                         Diagnostics& found);

/// What became of a motion with its table, why values are missing, and what was found of the case
/// in its positions.
void add_findings(const FoundMotion& motion,
                  const MechanismDescription& description,
                  const Mechanism& mechanism,
                  const PositionFindings& of_positions,
                  Diagnostics& found);

}  // namespace kinestat
