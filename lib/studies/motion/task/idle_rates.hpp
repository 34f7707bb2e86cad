// What a motion leaves open: what a body turns or shifts without any other feeling it.
#pragma once

#include <vector>

#include "studies/mobility/passive_freedom.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// What the case of the plan, if it knows speeds, leaves open of them.
std::vector<PassiveFreedom> freedoms_of_open_rate(std::vector<PassiveFreedom> passive,
                                                  const MotionPlan& plan,
                                                  const Mechanism& mechanism);

/// Takes the value from every reading of a place that such a freedom moves, and of a rate that the
/// case leaves open: `is_idle` is set. Where it stands depends on the steps and on the order of the
/// couplings.
void leave_out_idle_motions(const FoundMotion& motion,
                            const Mechanism& mechanism,
                            std::vector<MotionReading>& readings);

}  // namespace kinestat
