// Dyads and linkages of a synthesis task as tables for people.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "report/text_blocks.hpp"
#include "studies/synthesis/report/plane_text.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// The dyads of five positions, found with so many digits, or why there are none and what comes
/// nearest.
TextBlocks dyads_blocks(const SynthesisTask& task, int digits, const PlaneText& plane);

/// Why the dyads are a family, in words; the two positions by number that are the same.
std::string family_text(Degeneracy reason, std::span<const PositionJets> positions);

/// What speaks against a linkage, in words; of none "usable".
std::string_view phrase_of(Defect defect);

/// All that speaks against a linkage that passes the positions, as each may be the limit to move;
/// of others, why they do not.
std::string phrase_of(const Defects& defects);

/// The point of the coupler whose path is drawn, in words.
std::string_view traced_text(const SynthesisAnalysis& analysis);

/// All linkages with their verdicts and links, the best first; the cognates of those that are
/// usable, or of the one that comes nearest, with the limits that it takes; those that the file
/// does not ask for; and where they were written to.
TextBlocks linkages_blocks(const SynthesisTask& task,
                           const LinkageLimits& limits,
                           const PlaneText& plane);

}  // namespace kinestat
