// Synthesised linkages moved as mechanisms: whether they do what their verdicts say.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/synthesis/task/synthesis_options.hpp"

namespace kinestat {

/// Moves the linkages, all of them or those that will be written, and notes in the tasks what they
/// do. The motion is that of the mechanism which `describe_linkage` makes, and knows nothing of the
/// closed forms of the verdicts. Linkages whose positions leave no digits are passed over. A
/// verdict that does not hold is a warning, W0802.
void check_linkages(SynthesisAnalysis& analysis,
                    const SynthesisOptions& options,
                    Diagnostics& found);

}  // namespace kinestat
