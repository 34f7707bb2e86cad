// A finite motion for people: what happened, extremes, and some of the positions.
#pragma once

#include "report/motion_table.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// A section of a report, without a title of the file.
TextBlocks motion_blocks(const MotionTable& motion);

/// The same without the positions.
TextBlocks motion_summary(const MotionTable& motion);

}  // namespace kinestat
