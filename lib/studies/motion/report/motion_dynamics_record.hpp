// What reports say of a motion with inertia as a whole.
#pragma once

#include "record/record.hpp"
#include "studies/motion/report/motion_dynamics.hpp"

namespace kinestat {

const Record<MotionDynamics>& motion_dynamics_record();

}  // namespace kinestat
