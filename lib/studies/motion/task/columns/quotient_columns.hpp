// The columns of a motion that are quotients: ratio and mechanical advantage.
#pragma once

#include <vector>

#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// Those that the plan asks for, of the inputs and the first output of its case.
std::vector<MotionReading> quotient_readings(const FileUnits& units,
                                             const Mechanism& mechanism,
                                             const MotionPlan& plan);

}  // namespace kinestat
