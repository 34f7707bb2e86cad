// The mobility of one file as JSON.
#pragma once

#include "report/json_values.hpp"
#include "report/mobility_report.hpp"

namespace kinestat {

/// The key "mobility": counts, Reshetov's table, motions, redundant constraints, advice, remarks;
/// numbers in the units of the file.
Json mobility_json(const MobilityAnalysis& analysis);

}  // namespace kinestat
