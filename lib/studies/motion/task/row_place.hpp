// Where a row of a motion stands, in messages.
#pragma once

#include <string>

#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// "m = 5 deg, n = 20 mm": the positions of the drives.
std::string row_place(const MotionTable& table, const MotionRow& row);

}  // namespace kinestat
