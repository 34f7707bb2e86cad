// A finite motion in tables: how far drives go, what happens on the way, and every position.
#pragma once

#include <cstddef>

#include "report/table.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// More rows nobody reads, and a browser shows them slowly.
inline constexpr std::size_t kMostPositions = 1000;

/// The range of each drive and how far it comes.
Table drive_table(const MotionTable& motion);

/// Dead points, singular positions and limits, in the order in which they are passed.
Table event_table(const MotionTable& motion);

/// All columns of all positions; of more than kMostPositions only some at equal distances, the
/// first and the last among them.
Table position_table(const MotionTable& motion);

}  // namespace kinestat
