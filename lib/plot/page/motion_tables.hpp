// A finite motion in tables: how far drives go, what happens on the way, and every position.
#pragma once

#include "report/motion_table.hpp"
#include "report/table.hpp"

namespace kinestat {

/// The range of each drive and how far it comes.
Table drive_table(const MotionTable& motion);

/// Dead points, singular positions and limits, in the order in which they are passed.
Table event_table(const MotionTable& motion);

/// All columns of all positions.
Table position_table(const MotionTable& motion);

}  // namespace kinestat
