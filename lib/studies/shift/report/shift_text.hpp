// The states of a transmission as tables for people.
#pragma once

#include <cstddef>

#include "cases/analysis.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// The parts of a shift table, in this order.
struct ShiftBlocks {
  TextBlocks gears;         ///< the truth table, and what there is to say of its gears
  TextBlocks others;        ///< what is no gear, and why
  std::size_t other_count;  ///< of these, in all
  TextBlocks elements;      ///< torques and slips of the elements, changes of gear
};

/// How many of the combinations that are no gear are shown: of many the first of each class, or as
/// many as anybody reads.
enum class ShownOthers { first, all };

/// The analysis must have the section `shift`.
ShiftBlocks shift_parts(const Analysis& analysis, ShownOthers shown);

/// All parts, with the first of what is no gear.
TextBlocks shift_blocks(const Analysis& analysis);

}  // namespace kinestat
