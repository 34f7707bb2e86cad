// What must be worked out of a position for the columns of a motion.
#pragma once

#include "mechanism/mechanism.hpp"
#include "mechanism/motion_plan.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// For columns of places, of velocities, and of accelerations.
inline constexpr MotionDetail kPlaces = {};
inline constexpr MotionDetail kVelocities = {.velocity = true};
inline constexpr MotionDetail kAccelerations = {.velocity = true, .acceleration = true};

/// For all columns of the report of a plan.
MotionDetail detail_of(const MotionPlan& plan, const Mechanism& mechanism);

}  // namespace kinestat
