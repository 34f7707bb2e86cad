#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "cases/report/planet_fit_record.hpp"
#include "core/utf8.hpp"
#include "report/file/file_report.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "studies/shift/report/shift_text.hpp"

namespace kinestat {

namespace {

std::vector<std::string> coupling_names(const Topology& topology, const std::vector<int>& edges) {
  std::vector<std::string> names;
  for (const int e : edges) {
    names.push_back(topology.couplings[static_cast<std::size_t>(e)].name);
  }
  return names;
}

std::string head_text(const Analysis& analysis) {
  const Mechanism& mechanism = analysis.mechanism;
  const Topology& topology = mechanism.topology;
  std::string text = title_text(analysis.file, analysis.description);
  const int circuits = mechanism.graph.circuit_count();
  text += fmt::format("  {} bodies, {} couplings, {} circuit{}; tree {}; chords {}\n\n",
                      topology.body_count(),
                      topology.coupling_count(),
                      circuits,
                      circuits == 1 ? "" : "s",
                      fmt::join(coupling_names(topology, mechanism.graph.tree.branches), " "),
                      fmt::join(coupling_names(topology, mechanism.graph.tree.chords), " "));
  return text;
}

std::vector<std::string> count_row(const std::string& name, std::initializer_list<int> counts) {
  std::vector<std::string> row = {name};
  for (const int count : counts) {
    row.push_back(std::to_string(count));
  }
  return row;
}

void add_motions(const char* name, const MotionCounts& c, Table& table) {
  table.add(count_row(name, {c.order, c.gross_freedom, c.rank, c.net_freedom, c.net_constraint}));
}

void add_actions(const char* name, const std::optional<ActionCounts>& c, Table& table) {
  if (c) {
    table.add(count_row(
        name, {c->order, c->gross_constraint, c->rank, c->net_constraint, c->net_freedom}));
  }
}

// The spatial order leads: in the minimal one a planar linkage looks perfectly constrained.
std::string mobility_text(const MobilityCounts& counts) {
  Table motions({"Motions", "order", "freedoms F", "rank m", "net freedom F_N", "redundant C_N"});
  Table actions({"Actions", "order", "actions C", "rank a", "to be known C_N", "unresisted F_N"});
  add_motions("spatial", counts.spatial.motions, motions);
  add_actions("spatial", counts.spatial.actions, actions);
  if (counts.planar) {
    add_motions("planar", counts.planar->motions, motions);
    add_actions("planar", counts.planar->actions, actions);
  }
  add_motions("minimal", counts.minimal.motions, motions);
  add_actions("minimal", counts.minimal.actions, actions);
  return motions.text("  ") + "\n" + (actions.is_empty() ? "" : actions.text("  ") + "\n");
}

}  // namespace

std::string analysis_text(const Analysis& analysis) {
  std::string text = head_text(analysis) + mobility_text(analysis.mobility);
  const std::string planets =
      planet_fit_text(find_planet_fits(analysis.description), InUnits(analysis.description.units));
  text += planets.empty() ? "" : planets + "\n";
  if (analysis.shift) {
    text += shift_blocks(analysis).text();
  }
  for (const CaseAnalysis& one : analysis.cases) {
    text += case_text(analysis, one);
  }
  return text;
}

}  // namespace kinestat
