#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "cases/report/planet_fit_record.hpp"
#include "core/text.hpp"
#include "report/file/file_report.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "studies/motion/report/motion_text.hpp"
#include "studies/shift/report/shift_text.hpp"

namespace kinestat {

namespace {

// The spatial order leads: in the minimal one a planar linkage looks perfectly constrained.
TextBlocks counts_blocks(const Mechanism& mechanism, const MobilityCounts& counts) {
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
  TextBlocks blocks(fmt::format("Counts of {}, {}, {}\n",
                                counted(mechanism.topology.body_count(), "body", "bodies"),
                                counted(mechanism.topology.coupling_count(), "coupling"),
                                counted(mechanism.graph.circuit_count(), "circuit")));
  blocks += TextBlocks(std::move(table), "  ");
  blocks += "  'kinestat mobility' names what moves and what is redundant\n\n";
  return blocks;
}

}  // namespace

TextBlocks analysis_text(const Analysis& analysis, const MotionTable* motion) {
  TextBlocks text(title_text(analysis.file, analysis.description) + "\n");
  // A shift table tells the gears one below the other.
  if (!analysis.shift && analysis.cases.size() > 1) {
    text += overview_blocks(analysis);
  }
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
