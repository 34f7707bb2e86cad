// What is to be said of the statics of a case.
#pragma once

#include "core/diagnostic.hpp"
#include "report/analysis.hpp"

namespace kinestat {

/// The case must have an action solution.
void add_action_findings(const Analysis& analysis, const CaseAnalysis& one, Diagnostics& found);

}  // namespace kinestat
