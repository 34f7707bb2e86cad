// What became of a synthesis, as diagnostics.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// That a file which asks for linkages has none that is usable: E0802, with what is wrong with
/// them. A family of dyads leaves linkages to choose from, and fewer positions do.
void add_usability_findings(const SynthesisAnalysis& analysis, Diagnostics& found);

/// That the best linkage of a search is of no use, W0806: nothing bounds the ratio of its lengths,
/// and one of its links is far shorter than another; or it turns fully, but folds almost flat on
/// the way. The transmission angle between the positions alone may lead a search there.
void warn_of_degenerate_best(const SynthesisAnalysis& analysis, Diagnostics& found);

}  // namespace kinestat
