// The answers to a synthesis task as tables for people.
#pragma once

#include <string>

#include "report/text_blocks.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// Why choices or linkages are not usable, each with their number: "branch defect 2, too large 1".
std::string unusable_text(const SelectionCounts& counts);

/// How many a single limit keeps from being usable, by its key: "12 without 'class'"; empty if
/// none.
std::string one_limit_text(const SelectionCounts& counts);

TextBlocks synthesis_text(const SynthesisAnalysis& analysis);

/// The same without its title.
TextBlocks synthesis_blocks(const SynthesisAnalysis& analysis);

}  // namespace kinestat
