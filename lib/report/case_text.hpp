// One case of a report as tables for people.
#pragma once

#include <string>

#include "report/analysis.hpp"

namespace kinestat {

/// What is known and what was solved: freedoms, bodies, actuators, wrenches, power, and the
/// dependence on free parameters. Columns that are zero throughout are left out.
std::string case_text(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
