// What became of a synthesis, as diagnostics.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

/// That a file which asks for linkages has none that is usable: E0802, with what is wrong with
/// them. A family of dyads leaves linkages to choose from, and fewer positions do.
void add_usability_findings(const SynthesisAnalysis& analysis, Diagnostics& found);

}  // namespace kinestat
