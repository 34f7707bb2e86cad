#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "cases/report/planet_fit_record.hpp"
#include "core/utf8.hpp"
#include "report/column_table.hpp"
#include "report/file/file_report.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "studies/motion/report/motion_text.hpp"
#include "studies/shift/report/shift_text.hpp"

namespace kinestat {

namespace {

const std::string kNoNumber = "-";

// Where the cases are not those of a shift table, which tells the gears one below the other.
TextBlocks overview_blocks(const Analysis& analysis) {
  if (analysis.shift || analysis.cases.size() < 2) {
    return {};
  }
  const InUnits in(analysis.description.units);
  const FileUnits& units = in.units();
  const auto with_unit = [&](const char* what, QuantityKind kind) {
    return fmt::format("{} [{}]", what, units.text(kind));
  };
  std::vector<TextColumn> columns = {
      {.head = "Case", .cells = {}},
      {.head = "ratio", .cells = {}},
      {.head = "efficiency", .cells = {}},
      {.head = with_unit("input power", QuantityKind::power), .cells = {}},
      {.head = with_unit("largest force", QuantityKind::force), .cells = {}},
      {.head = with_unit("largest moment", QuantityKind::moment), .cells = {}}};
  const auto action_cell = [&](const LargestAction& one) {
    return one.size > 0.0 ? format_short(in.action(one.size, one.is_couple)) : kNoNumber;
  };
  for (const CaseAnalysis& one : analysis.cases) {
    const LargestActions largest = largest_actions(analysis.mechanism, one);
    columns[0].cells.push_back(printable(one.which.label));
    columns[1].cells.push_back(ratio_cell(one, analysis.mechanism, in));
    columns[2].cells.push_back(efficiency_cell(one, analysis.mechanism));
    columns[3].cells.push_back(one.power ? format_short(in.power(one.power->input)) : kNoNumber);
    columns[4].cells.push_back(action_cell(largest.force));
    columns[5].cells.push_back(action_cell(largest.moment));
  }
  std::erase_if(columns, [](const TextColumn& column) {
    return std::ranges::all_of(column.cells,
                               [](const std::string& cell) { return cell == kNoNumber; });
  });
  return columns.size() > 1 ? TextBlocks(std::move(columns)) : TextBlocks();
}

// The spatial order leads: in the minimal one a planar linkage looks perfectly constrained.
TextBlocks counts_blocks(const Mechanism& mechanism, const MobilityCounts& counts) {
  const auto counted = [](auto number, std::string_view one, std::string_view several) {
    return fmt::format("{} {}", number, number == 1 ? one : several);
  };
  std::vector<const SideCounts*> orders = {&counts.spatial};
  std::vector<std::string> head = {"", "in space"};
  if (counts.planar) {
    orders.push_back(&*counts.planar);
    head.emplace_back("in the plane");
  }
  Table table(std::move(head));
  const auto add = [&](const char* what, auto&& count) {
    std::vector<std::string> row = {what};
    for (const SideCounts* one : orders) {
      const std::optional<int> number = count(*one);
      row.push_back(number ? std::to_string(*number) : "-");
    }
    table.add(std::move(row));
  };
  using Count = std::optional<int>;
  add("degrees of freedom", [](const SideCounts& one) { return Count(one.motions.net_freedom); });
  add("redundant constraints",
      [](const SideCounts& one) { return Count(one.motions.net_constraint); });
  if (counts.spatial.actions) {
    add("actions to be known", [](const SideCounts& one) {
      return one.actions ? Count(one.actions->net_constraint) : std::nullopt;
    });
  }
  TextBlocks blocks(
      fmt::format("Counts of {}, {}, {}\n",
                  counted(mechanism.topology.body_count(), "body", "bodies"),
                  counted(mechanism.topology.coupling_count(), "coupling", "couplings"),
                  counted(mechanism.graph.circuit_count(), "circuit", "circuits")));
  blocks += TextBlocks(std::move(table), "  ");
  blocks += "  'kinestat mobility' names what moves and what is redundant\n\n";
  return blocks;
}

}  // namespace

TextBlocks analysis_text(const Analysis& analysis, const MotionTable* motion) {
  TextBlocks text(title_text(analysis.file, analysis.description) + "\n");
  text += overview_blocks(analysis);
  const std::string planets =
      planet_fit_text(find_planet_fits(analysis.description), InUnits(analysis.description.units));
  text += planets.empty() ? "" : planets + "\n";
  if (analysis.shift) {
    text += shift_blocks(analysis);
  }
  if (motion != nullptr) {
    text += motion_summary(*motion);
  }
  for (const CaseAnalysis& one : analysis.cases) {
    text += case_text(analysis, one);
  }
  return text += counts_blocks(analysis.mechanism, analysis.mobility);
}

}  // namespace kinestat
