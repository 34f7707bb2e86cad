#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "core/utf8.hpp"
#include "report/column_table.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"

namespace kinestat {

namespace {

const std::string kNoNumber = "-";

}  // namespace

TextBlocks overview_blocks(const Analysis& analysis) {
  const InUnits in(analysis.description.units);
  const FileUnits& units = in.units();
  const auto with_unit = [&](const char* what, QuantityKind kind) {
    return fmt::format("{} [{}]", what, units.text(kind));
  };
  std::vector<TextColumn> columns = {
      {.head = in_drawn_position(analysis.description).empty() ? "Case" : "Case, as drawn",
       .cells = {}},
      {.head = "ratio", .cells = {}},
      {.head = "efficiency", .cells = {}},
      {.head = with_unit("input power", QuantityKind::power), .cells = {}},
      {.head = with_unit("largest force", QuantityKind::force), .cells = {}},
      {.head = with_unit("largest moment", QuantityKind::moment), .cells = {}}};
  const auto action_cell = [&](const LargestAction& one) {
    return one.size > 0.0 && !one.is_open ? format_short(in.action(one.size, one.is_couple))
                                          : kNoNumber;
  };
  for (const CaseAnalysis& one : analysis.cases) {
    const LargestActions largest = largest_actions(analysis.mechanism, one);
    columns[0].cells.push_back(printable(one.which.label));
    columns[1].cells.push_back(ratio_cell(one, analysis.mechanism, in));
    columns[2].cells.push_back(efficiency_cell(one, analysis.mechanism));
    columns[3].cells.push_back(input_power_cell(one, analysis.mechanism, in));
    columns[4].cells.push_back(action_cell(largest.force));
    columns[5].cells.push_back(action_cell(largest.moment));
  }
  std::erase_if(columns, [](const TextColumn& column) {
    return std::ranges::all_of(column.cells,
                               [](const std::string& cell) { return cell == kNoNumber; });
  });
  return columns.size() > 1 ? TextBlocks(std::move(columns)) : TextBlocks();
}

}  // namespace kinestat
