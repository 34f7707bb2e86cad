// Where a drive stands at each step, as somebody would type it.
#pragma once

#include <optional>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/whole_range.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/motion_plan.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// The steps of each drive counted in the unit of the file; empty where its ends are no fractions
/// of it, or are not those of the plan.
std::vector<std::optional<WholeRange>> drive_counts(const MechanismDescription& description,
                                                    const Topology& topology,
                                                    const MotionPlan& plan);

/// Where a drive stands at a position, in the unit of the file: the number that would be typed
/// there, 30 deg and not 29.999999999999996; what the step is where the motion ends before it.
/// `count` is that of the drive.
double shown_drive(const MechanismDescription& description,
                   const Topology& topology,
                   const FoundMotion& motion,
                   const std::optional<WholeRange>& count,
                   std::size_t drive,
                   int position);

}  // namespace kinestat
