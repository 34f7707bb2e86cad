// Where a drive stands at each step, as somebody would type it.
#pragma once

#include <optional>
#include <vector>

#include "description/mechanism_description.hpp"
#include "expression/whole_range.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/motion_plan.hpp"

namespace kinestat {

/// The steps of each drive counted in the unit of the file; empty where its ends are no fractions
/// of it, or are not those of the plan.
std::vector<std::optional<WholeRange>> drive_counts(const MechanismDescription& description,
                                                    const Topology& topology,
                                                    const MotionPlan& plan);

}  // namespace kinestat
