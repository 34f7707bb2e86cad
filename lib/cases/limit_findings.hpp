// What a gear takes beyond the limits of `shift`.
#pragma once

#include "cases/case_findings.hpp"

namespace kinestat {

/// Warns of every limit that the case exceeds, at the limit; of a case that is no gear of nothing.
void add_limit_findings(const JudgedFile& file,
                        const CaseAnalysis& one,
                        const ShiftState& state,
                        CaseFindings& found);

}  // namespace kinestat
