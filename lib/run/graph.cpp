#include "run/graph.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "network/bases.hpp"
#include "network/network_matrices.hpp"
#include "report/graph_report.hpp"

namespace kinestat {

namespace {

void append(std::vector<LabelledMatrix> more, std::vector<LabelledMatrix>& all) {
  all.insert(all.end(),
             std::make_move_iterator(more.begin()),
             std::make_move_iterator(more.end()));
}

// The last of the matrices of a side is its network matrix: its echelon form and, for a case that
// knows magnitudes of this side, its partition.
void add_side(std::vector<LabelledMatrix> side,
              const std::vector<std::string>& primary,
              std::vector<LabelledMatrix>& all) {
  const LabelledMatrix network = side.back();
  append(std::move(side), all);
  all.push_back(echelon_of(network));
  if (!primary.empty()) {
    append(partition_of(network, primary), all);
  }
}

std::vector<LabelledMatrix> all_matrices(const Mechanism& mechanism, const Case* which) {
  const Topology& topology = mechanism.topology;
  std::vector<std::string> motions;
  std::vector<std::string> actions;
  if (which != nullptr) {
    for (const Primary& primary : which->motions) {
      motions.push_back(topology.freedom_name(primary.index));
    }
    for (const Primary& primary : which->actions) {
      actions.push_back(topology.action_name(primary.index));
    }
  }
  std::vector<LabelledMatrix> all = graph_matrices(topology, mechanism.graph);
  add_side(motion_matrices(topology,
                           mechanism.geometry,
                           mechanism.graph,
                           motion_basis(mechanism.geometry, mechanism.kinematic_order)),
           motions,
           all);
  add_side(action_matrices(topology,
                           mechanism.geometry,
                           mechanism.graph,
                           action_basis(mechanism.geometry, mechanism.static_order)),
           actions,
           all);
  return all;
}

// Null if the file has no cases; an unknown label is an error.
const Case* choose_case(const std::vector<Case>& cases,
                        const std::string& label,
                        Diagnostics& found) {
  if (label.empty()) {
    return cases.empty() ? nullptr : &cases.front();
  }
  const auto at = std::ranges::find(cases, label, &Case::label);
  if (at != cases.end()) {
    return &*at;
  }
  std::vector<std::string> labels;
  for (const Case& one : cases) {
    labels.push_back(one.label);
  }
  found.error("E0101",
              {},
              fmt::format("--case: there is no case '{}'", label),
              fmt::format("its cases are {}", plain_list(labels)));
  return nullptr;
}

void graph_file(const std::string& path,
                Matrices matrices,
                const std::string& case_label,
                const AnalyseOptions& options,
                Outcome& outcome) {
  SourceFile source;
  Diagnostics found;
  if (const std::optional<Loaded> loaded = load(path, options.overrides, source, found)) {
    const Case* which = choose_case(loaded->mechanism.cases, case_label, found);
    if (!found.has_errors()) {
      const FileReport report =
          make_graph_report(path,
                            loaded->description,
                            loaded->mechanism,
                            matrices == Matrices::all ? all_matrices(loaded->mechanism, which)
                                                      : std::vector<LabelledMatrix>{},
                            {.json = options.format == StreamFormat::json,
                             .csv = options.format == StreamFormat::csv,
                             .text = options.format == StreamFormat::table,
                             .layout = Layout::pretty});
      outcome.out += report.json + report.text;
      for (const NamedTable& table : report.csv) {
        outcome.out += table.text;
      }
    }
  }
  add_diagnostics(source, found, options.strictness, outcome);
}

}  // namespace

Outcome graph_files(const std::vector<std::string>& paths,
                    Matrices matrices,
                    const std::string& case_label,
                    const AnalyseOptions& options) {
  Outcome outcome;
  for (const std::string& path : paths) {
    try {
      graph_file(path, matrices, case_label, options, outcome);
    } catch (const ContractViolation& bug) {
      add_bug(path, bug.what(), outcome);
    }
  }
  return outcome;
}

}  // namespace kinestat
