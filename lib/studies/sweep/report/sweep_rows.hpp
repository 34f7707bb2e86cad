// The rows of a sweep as text: wide CSV, or one JSON object a line.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/exact_text.hpp"
#include "studies/sweep/report/sweep_column.hpp"
#include "studies/sweep/sweep_plan.hpp"

namespace kinestat {

enum class RowFormat {
  csv,
  json,
  npy  ///< no text: see SweepRowArray
};

/// As --format takes it.
constexpr std::string_view word_of(RowFormat format) {
  switch (format) {
    case RowFormat::csv:
      return "csv";
    case RowFormat::json:
      return "json";
    case RowFormat::npy:
      return "npy";
  }
  return "";
}

/// What one case of one state gave. A NaN is a quantity without a value.
struct SweepRow {
  std::size_t which = 0;  ///< of the cases that the sweep runs
  std::string_view status = "solved";
  std::vector<double> values;  ///< of each quantity, in its unit
};

/// The titles of the columns: the varied parameters, the case, the quantities, the status. A title
/// has the unit in brackets, "C1 [N*m]".
std::vector<std::string> sweep_titles(const SweepPlan& plan, std::span<const SweepColumn> columns);

/// What stands before each value of a JSON row: the title is its key.
std::vector<std::string> json_row_keys(std::span<const std::string> titles);

/// Writes rows as text. Whole bare numbers of parameters, such as teeth, have no decimal point.
class SweepRowText {
 public:
  SweepRowText(const SweepPlan& plan,
               std::span<const Case> cases,
               std::span<const SweepColumn> columns,
               RowFormat format);

  /// Takes the places of a state on the axes, which its rows then begin with.
  void enter(std::span<const std::uint64_t> places);

  /// Appends the row of a case of that state, with its line end.
  void append(const SweepRow& row, std::string& text);

 private:
  // A value with its text: in the next row of the case it is often the same.
  struct Cell {
    double value = 0.0;
    std::size_t length = 0;
    std::array<char, kRoomForExact> text = {};

    void take(double next);

    /// Where the text ends then. There must be room for the longest.
    char* append_to(char* end) const;
  };

  void append_parameter(std::size_t axis, std::uint64_t place);
  char* append_values(const SweepRow& row, char* end);
  char* append_members(const SweepRow& row, char* end);

  const SweepPlan& plan_;
  RowFormat format_;
  std::vector<std::string> keys_;      ///< of JSON
  std::vector<std::string> cases_;     ///< as they stand in a row
  std::string beginning_;              ///< of the rows of the state
  std::vector<std::uint64_t> places_;  ///< of the state
  std::vector<std::size_t> ends_;      ///< of the text of each axis in the beginning
  std::vector<Cell> cells_;            ///< of each case the quantities, as its last row has them
  std::vector<char> numbers_;          ///< of the row that is being written, with room for any
};

}  // namespace kinestat
