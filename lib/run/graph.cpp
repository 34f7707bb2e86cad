#include "run/graph.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cases/chosen_case.hpp"
#include "core/text.hpp"
#include "files/each_file.hpp"
#include "network/bases.hpp"
#include "network/network_matrices.hpp"
#include "studies/graph/graph_report.hpp"

namespace kinestat {

namespace {

void append(std::vector<LabelledMatrix> more, std::vector<LabelledMatrix>& all) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
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

// A unit screw in the units of the file: what a rate (or magnitude) of 1 in its unit adds to each
// coordinate in the coordinate's unit.
Vec6 in_units(const Vec6& screw, double column_unit, double first_unit, double last_unit) {
  Vec6 result = screw;
  result.head<3>() *= column_unit / first_unit;
  result.tail<3>() *= column_unit / last_unit;
  return result;
}

// The geometry whose unit screws, as numbers, are those of the file's units.
Geometry in_file_units(const Topology& topology, const Geometry& geometry, const FileUnits& units) {
  Geometry result = geometry;
  result.origin = LocalOrigin();
  const double turn = units.factor(QuantityKind::angular_velocity);
  const double slide = units.factor(QuantityKind::velocity);
  for (std::size_t f = 0; f < result.motions.size(); ++f) {
    const double column = topology.freedoms[f].is_rotation ? turn : slide;
    result.motions[f] = Twist::from_coordinates(in_units(
        about_world(geometry.motions[f], geometry.origin).coordinates(), column, turn, slide));
  }
  const double moment = units.factor(QuantityKind::moment);
  const double force = units.factor(QuantityKind::force);
  for (std::size_t a = 0; a < result.actions.size(); ++a) {
    const double column = topology.actions[a].is_couple ? moment : force;
    result.actions[a] = Wrench::from_coordinates(in_units(
        about_world(geometry.actions[a], geometry.origin).coordinates(), column, moment, force));
  }
  result.length = geometry.length / units.factor(QuantityKind::length);
  return result;
}

std::vector<LabelledMatrix> all_matrices(const Loaded& loaded, const Case* which) {
  const Mechanism& mechanism = loaded.mechanism;
  const Topology& topology = mechanism.topology;
  const Geometry geometry = in_file_units(topology, mechanism.geometry, loaded.description.units);
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
  add_side(
      motion_matrices(
          topology, geometry, mechanism.graph, motion_basis(geometry, mechanism.kinematic_order)),
      motions,
      all);
  add_side(action_matrices(
               topology, geometry, mechanism.graph, action_basis(geometry, mechanism.static_order)),
           actions,
           all);
  return all;
}

void graph_file(const std::string& path,
                const std::vector<std::string>& paths,
                Matrices matrices,
                const std::string& case_label,
                const AnalyseOptions& options,
                Outcome& outcome) {
  SourceFile source;
  Diagnostics found;
  if (const std::optional<Loaded> loaded = load(path, options.load, source, found)) {
    const Case* which = choose_case(loaded->mechanism.cases, case_label, found);
    if (!found.has_errors()) {
      const FileReport report = make_graph_report(
          path,
          loaded->description,
          loaded->mechanism,
          matrices == Matrices::all ? all_matrices(*loaded, which) : std::vector<LabelledMatrix>{},
          stream_forms(options.format, paths.size()));
      add_to_stream(report, path, paths, options, outcome);
    }
  }
  add_diagnostics(source, found, options.strictness, outcome);
}

}  // namespace

Outcome graph_files(const std::vector<std::string>& paths,
                    Matrices matrices,
                    const std::string& case_label,
                    const AnalyseOptions& options) {
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    graph_file(path, paths, matrices, case_label, options, outcome);
  });
}

}  // namespace kinestat
