// Findings about what acts as the mechanism stands and moves.
#pragma once

#include <string>

#include "cases/findings/case_findings.hpp"

namespace kinestat {

/// Where a curve begins and ends, in the units of the file: "from 0 to 90 deg".
std::string reach_of(const Curve& curve, const FileUnits& units);

/// Forces of inertia, springs and curves that have no value, or one that is hardly known; bodies
/// whose inertia the motion asks for.
void add_load_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

}  // namespace kinestat
