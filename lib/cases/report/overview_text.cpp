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
  std::vector<LargestActions> largest;
  for (const CaseAnalysis& one : analysis.cases) {
    largest.push_back(largest_actions(analysis.mechanism, one));
  }
  std::vector<TextColumn> columns = {
      {.head = in_drawn_position(analysis.description).empty() ? "Case" : "Case, as drawn",
       .cells = {}},
      {.head = "ratio", .cells = {}},
      {.head = "efficiency", .cells = {}},
      {.head = with_unit("input power", QuantityKind::power), .cells = {}}};
  for (const CaseAnalysis& one : analysis.cases) {
    columns[0].cells.push_back(printable(one.which.label));
    columns[1].cells.push_back(ratio_cell(one, analysis.mechanism, in));
    columns[2].cells.push_back(efficiency_cell(one, analysis.mechanism));
    columns[3].cells.push_back(input_power_cell(one, analysis.mechanism, in));
  }
  std::erase_if(columns, [](const TextColumn& column) {
    return std::ranges::all_of(column.cells,
                               [](const std::string& cell) { return cell == kNoNumber; });
  });
  const auto add = [&](const char* what, QuantityKind kind, LargestAction LargestActions::*member) {
    TextColumn column{.head = with_unit(what, kind), .cells = {}};
    bool has_any = false;
    for (const LargestActions& all : largest) {
      const LargestAction& one = all.*member;
      column.cells.push_back(one.is_known() ? format_short(in.action(one.size, one.is_couple))
                                            : kNoNumber);
      has_any = has_any || (one.is_known() && one.size > 0.0);
    }
    if (has_any) {
      columns.push_back(std::move(column));
    }
  };
  const bool has_losses = std::ranges::any_of(
      analysis.cases, [](const CaseAnalysis& one) { return one.efficiency.has_value(); });
  add(has_losses ? "largest force without losses" : "largest force",
      QuantityKind::force,
      &LargestActions::force);
  add(has_losses ? "largest moment without losses" : "largest moment",
      QuantityKind::moment,
      &LargestActions::moment);
  return columns.size() > 1 ? TextBlocks(std::move(columns)) : TextBlocks();
}

}  // namespace kinestat
