// The mobility of one file for people.
#pragma once

#include <string>

#include "report/text_blocks.hpp"
#include "studies/mobility/report/mobility_report.hpp"

namespace kinestat {

/// Title, size, and the sentences of mobility_remarks, then all of mobility_blocks.
TextBlocks mobility_text(const MobilityAnalysis& analysis);

/// The tables of the mobility, in reading order.
struct MobilityBlocks {
  TextBlocks counts;
  TextBlocks reshetov;  ///< a table a circuit
  TextBlocks motions;   ///< and redundant constraints and repairs
};

MobilityBlocks mobility_blocks(const MobilityAnalysis& analysis);

/// The self-stresses in space and, where the mechanism has one, in its plane or in the least order
/// that holds its motions; then the advice. Only for a mechanism with places.
std::string redundancies_text(const MobilityAnalysis& analysis);

}  // namespace kinestat
