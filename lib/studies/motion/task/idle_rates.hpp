// Rates that a motion leaves open: of what a body turns or shifts without any other feeling it.
#pragma once

#include <vector>

#include "studies/mobility/passive_freedom.hpp"
#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/motion_columns.hpp"

namespace kinestat {

/// Whether it turns or shifts the freedom.
bool moves_freedom(const PassiveFreedom& one, int freedom);

/// Whether it moves a point of the body [m], drawn there.
bool moves_point(const PassiveFreedom& one,
                 BodyId body,
                 const Vec3& drawn,
                 const Mechanism& mechanism);

/// Whether the case of the plan knows speeds, and none that says how fast this one goes.
bool is_rate_open(const PassiveFreedom& one, const MotionPlan& plan, const Mechanism& mechanism);

/// Takes the value from every reading of a rate that such a freedom moves: `is_idle` is set.
void leave_out_idle_rates(const FoundMotion& motion,
                          const Mechanism& mechanism,
                          std::vector<MotionReading>& readings);

}  // namespace kinestat
