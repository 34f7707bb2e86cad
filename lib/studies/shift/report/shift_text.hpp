// The states of a transmission as tables for people.
#pragma once

#include "cases/analysis.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// The truth table, what is no gear and why, torques and slips of the elements, changes of gear.
/// The analysis must have the section `shift`.
TextBlocks shift_blocks(const Analysis& analysis);

}  // namespace kinestat
