// The rows of a sweep as numbers, for pictures, and as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kinestat {

/// What one case of one state gave.
struct SweepTableRow {
  std::vector<double> places;  ///< of the varied parameters, in their units
  std::string label;           ///< of the case
  std::vector<double> values;  ///< NaN where a quantity has none
};

/// A picture of a sweep shows no more states than these.
inline constexpr std::uint64_t kMostSweptStates = 20'000;

/// Columns are titled as in the result of the sweep: "C1 [N*m]".
struct SweepTable {
  std::uint64_t states = 0;         ///< of the plan
  std::vector<std::string> varied;  ///< parameters
  std::vector<std::string> quantities;
  std::vector<SweepTableRow> rows;  ///< none where there are more states than kMostSweptStates
  bool is_sample = false;           ///< the states are drawn, and no combinations
  std::string csv = {};  ///< the rows with their status and heading, as `sweep` writes them
};

}  // namespace kinestat
