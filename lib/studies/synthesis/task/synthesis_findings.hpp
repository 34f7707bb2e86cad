// What became of a synthesis, as diagnostics.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// That a file which asks for linkages has none that is usable: E0802, with what is wrong with
/// them. A family of dyads leaves linkages to choose from, and fewer positions do.
void add_usability_findings(const SynthesisAnalysis& analysis, Diagnostics& found);

/// That the best linkage of a search without `link_ratio` has a link that cannot be built: W0806.
/// The transmission angle alone may lead it to two dyads that almost coincide.
void warn_of_short_links(const SynthesisAnalysis& analysis, Diagnostics& found);

}  // namespace kinestat
