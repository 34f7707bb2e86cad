// The mobility of one file as a table of comma-separated values.
#pragma once

#include <string>

#include "report/json_values.hpp"
#include "report/mobility_report.hpp"

namespace kinestat {

/// Every number of the JSON value, quantities named by their paths.
std::string mobility_csv(const MobilityAnalysis& analysis, const Json& mobility);

}  // namespace kinestat
