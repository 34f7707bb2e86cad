// Where the speeds of a motion grow without bound.
#pragma once

#include <span>
#include <vector>

#include "studies/motion/motion.hpp"
#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/motion_events.hpp"

namespace kinestat {

/// Whether the case of a motion gives the speed of a freedom that is no drive of it.
bool gives_speed_behind_drives(const MotionPlan& plan, const Mechanism& mechanism);

/// The dead points of such freedoms, in steps: to give it its speed there, the drive would have to
/// be infinitely fast.
std::vector<double> find_speed_poles(const FoundMotion& motion,
                                     const Mechanism& mechanism,
                                     std::span<const DeadPoint> dead_points);

}  // namespace kinestat
