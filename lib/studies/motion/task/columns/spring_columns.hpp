// The columns of springs: length or angle, and force or couple.
#pragma once

#include <vector>

#include "expression/file_units.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// Spring after spring; of positions whose actions are solved.
std::vector<MotionReading> spring_readings(const FileUnits& units, const Mechanism& mechanism);

}  // namespace kinestat
