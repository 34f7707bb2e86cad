// The answers to a synthesis task as one tidy table.
#pragma once

#include <string>

#include "report/json_values.hpp"
#include "report/synthesis_report.hpp"

namespace kinestat {

/// One row a number of the JSON report: the case is the number of the task, the element the key
/// below it, the quantity the path from there. What a selection tried belongs to no case.
std::string synthesis_csv(const SynthesisAnalysis& analysis, const Json& synthesis);

}  // namespace kinestat
