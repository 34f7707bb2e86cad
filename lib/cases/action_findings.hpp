// What is to be said of the statics of a case.
#pragma once

#include "cases/case_findings.hpp"

namespace kinestat {

/// Why a case has no actions, or not all of them. It must have an action solution.
void add_action_status_findings(const JudgedFile& file,
                                const CaseAnalysis& one,
                                CaseFindings& found);

/// What the actions that it has cannot be: reactions without friction, contacts that pull, cables
/// in compression or slip. Likewise.
void add_action_value_findings(const JudgedFile& file,
                               const CaseAnalysis& one,
                               CaseFindings& found);

/// Warns of segments that would be in compression, with the pretension that keeps them in tension,
/// and of cables that friction does not hold.
void add_cable_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found);

}  // namespace kinestat
