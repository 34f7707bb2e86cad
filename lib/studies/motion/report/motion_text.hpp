// A finite motion for people: what happened, extremes, and some of the positions.
#pragma once

#include <string>

#include "report/text_blocks.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// A section of a report, without a title of the file.
TextBlocks motion_blocks(const MotionTable& motion);

/// The same without the positions.
TextBlocks motion_summary(const MotionTable& motion);

/// Lines on how well circuits close, and what closed a drawn position that is apart.
TextBlocks motion_remarks(const MotionTable& motion);

/// How well circuits close whose largest error is `worst`, as share of the size of the mechanism.
std::string closure_sentence(double worst);

/// The least and the greatest value of every quantity, and where; empty if nothing moves.
TextBlocks motion_extremes(const MotionTable& motion);

/// "motor 12.5, then -3.1 N*m": what drives do on either side of a friction reversal; empty of
/// other events, and where the report has no actions.
std::string jump_text(const MotionTable& motion, const MotionEvent& event);

}  // namespace kinestat
