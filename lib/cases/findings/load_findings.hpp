// Findings about what acts as the mechanism stands and moves.
#pragma once

#include "cases/findings/case_findings.hpp"

namespace kinestat {

/// Forces of inertia, springs and curves that have no value, or one that is hardly known; bodies
/// whose inertia the motion asks for.
void add_load_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

}  // namespace kinestat
