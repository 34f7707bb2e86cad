// The rows of a sweep as text: wide CSV, or one JSON object a line.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studies/sweep/report/sweep_column.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace kinestat {

enum class RowFormat { csv, json };

/// What one case of one state gave. A NaN is a quantity without a value.
struct SweepRow {
  std::size_t which = 0;  ///< of the cases that the sweep runs
  std::string_view status = "solved";
  std::vector<double> values;  ///< of each quantity, in its unit
};

/// Writes rows: the varied parameters, the case, the quantities, the status. The title of a column
/// has its unit in brackets, "C1 [N*m]", and is the key of the JSON object. Whole bare numbers of
/// parameters, such as teeth, have no decimal point.
class SweepRowText {
 public:
  SweepRowText(const SweepPlan& plan,
               std::span<const Case> cases,
               std::span<const SweepColumn> columns,
               RowFormat format);

  /// The line with the titles; JSON has none.
  const std::string& header() const { return header_; }

  const std::vector<std::string>& titles() const { return titles_; }

  /// How every file of these rows begins.
  std::string signature() const;

  /// Takes the places of a state on the axes, which its rows then begin with.
  void enter(std::span<const std::uint64_t> places);

  /// Appends the row of a case of that state, with its line end.
  void append(const SweepRow& row, std::string& text) const;

 private:
  const SweepPlan& plan_;
  RowFormat format_;
  std::vector<std::string> titles_;
  std::vector<std::string> keys_;   ///< of JSON: what stands before each value
  std::vector<std::string> cases_;  ///< as they stand in a row
  std::string header_;
  std::string beginning_;  ///< of the rows of the state
};

}  // namespace kinestat
