// The report of one file as tidy tables, one a pass.
#pragma once

#include <string>
#include <vector>

#include "report/analysis.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// The header line that every table begins with.
inline constexpr std::string_view kCsvHeader =
    "mechanism,case,pass,element,quantity,value,unit,status\n";

struct CsvTable {
  std::string pass;  ///< "mobility", "kinematics", "statics", "power"
  std::string text;  ///< header and rows
};

/// One row a number of the JSON report: `quantity` is its path below the element, `value` is empty
/// where it is null. `status` is that of the pass; of actions that complete equilibrium it is their
/// method, minimum_norm or stiffness. Passes that no case asked for have no table.
std::vector<CsvTable> analysis_csv(const Analysis& analysis, const Json& report);

}  // namespace kinestat
