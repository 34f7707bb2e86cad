// The answers to a synthesis task as tables for people.
#pragma once

#include <string>

#include "report/text_blocks.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

TextBlocks synthesis_text(const SynthesisAnalysis& analysis);

/// The same without its title.
TextBlocks synthesis_blocks(const SynthesisAnalysis& analysis);

}  // namespace kinestat
