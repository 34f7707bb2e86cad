// The mobility of one file for people.
#pragma once

#include "report/mobility_report.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// Title, size, and the sentences of mobility_remarks, then all of mobility_blocks.
std::string mobility_text(const MobilityAnalysis& analysis);

/// Counts, Reshetov's table, motions, redundant constraints and repairs.
TextBlocks mobility_blocks(const MobilityAnalysis& analysis);

}  // namespace kinestat
