// At which of its dead points a motion turns a freedom back.
#pragma once

#include <vector>

#include "studies/motion/task/found_motion.hpp"
#include "studies/motion/task/motion_events.hpp"

namespace kinestat {

/// Sets `reverses` of the dead points, which are in the order of the motion: true of all within it,
/// once where a drive turns back or rests there. At an end a freedom comes to rest or leaves it,
/// but does not turn back, unless the motion ends where it began: run again and again it turns back
/// there once a cycle.
void judge_reversals(const Mechanism& mechanism,
                     const FoundMotion& motion,
                     std::vector<DeadPoint>& points);

}  // namespace kinestat
