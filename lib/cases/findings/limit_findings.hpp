// Findings about gears that exceed the limits of `shift`.
#pragma once

#include "cases/findings/case_findings.hpp"

namespace kinestat {

/// Adds a warning (W0712) for every limit that the gear exceeds, at the line of the limit. `state`
/// is that of the gear.
void add_limit_findings(const JudgedFile& file,
                        const CaseAnalysis& one,
                        const ShiftState& state,
                        CaseFindings& found);

}  // namespace kinestat
