// The columns of a motion that say what couplings bear, whatever its direction.
#pragma once

#include <vector>

#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// Of each coupling that bears forces their resultant with its friction [N]: without those of
/// actuators on it, of central hinges without the planets' part, of planets that of the most loaded
/// one. Of each with friction its couple [N·m] or drag [N], and the power that it loses [W].
std::vector<MotionReading> reaction_readings(const FileUnits& units, const Mechanism& mechanism);

}  // namespace kinestat
