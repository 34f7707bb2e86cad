// Where speeds and actions of a motion may grow without bound.
#pragma once

#include <span>
#include <vector>

#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/motion_events.hpp"

namespace kinestat {

/// Whether the case of a motion gives or asks for what happens at a freedom that is no drive of it:
/// at its dead point a speed that is given there, or an action that is not, knows no bound.
bool may_have_poles(const MotionPlan& plan, const Mechanism& mechanism);

/// The dead points, in steps.
std::vector<double> find_poles(const FoundMotion& motion, std::span<const DeadPoint> dead_points);

}  // namespace kinestat
