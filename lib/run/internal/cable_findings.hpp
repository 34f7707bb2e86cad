// What is to be said of the ropes of a case.
#pragma once

#include "run/internal/case_findings.hpp"

namespace kinestat {

/// Warns of segments that would be pushed, with the pretension that keeps them taut, and of ropes
/// that friction does not hold.
void add_cable_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

}  // namespace kinestat
