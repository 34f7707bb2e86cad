// What is to be said of the cables of a case.
#pragma once

#include "cases/case_findings.hpp"

namespace kinestat {

/// Warns of segments that would be in compression, with the pretension that keeps them in tension,
/// and of cables that friction does not hold.
void add_cable_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

}  // namespace kinestat
