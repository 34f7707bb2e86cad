// The columns of a motion that inertia has.
#pragma once

#include <vector>

#include "studies/motion/task/motion_columns.hpp"

namespace kinestat {

/// Energy, the wrenches on the ground and of shaking, and the reduced equation at the drives.
std::vector<MotionReading> dynamic_readings(const FileUnits& units,
                                            const Mechanism& mechanism,
                                            const MotionPlan& plan);

}  // namespace kinestat
