#include "network/network_matrices.hpp"

#include <algorithm>

#include "graph/cutsets.hpp"
#include "math/elimination/echelon.hpp"

namespace kinestat {

namespace {

std::vector<std::string> edge_names(const Topology& topology, const std::vector<int>& edges) {
  std::vector<std::string> names;
  for (const int e : edges) {
    names.push_back(topology.couplings[static_cast<std::size_t>(e)].name);
  }
  return names;
}

// One expanded column: which column of B or Q it repeats, its screw and its name.
struct Column {
  int edge_column = 0;
  Vec6 screw = Vec6::Zero();
  std::string name;
};

// How one side (motions or actions) expands the graph.
struct Expansion {
  std::vector<Column> columns;
  MatXi edges;  ///< B or Q
  std::vector<std::string> edge_rows;
  std::vector<std::string> coordinates;
};

// The screws of the couplings, one coupling behind the other in the order of the graph's columns.
template <class Screw>
std::vector<Column> screw_columns(const Topology& topology,
                                  const CouplingGraph& graph,
                                  const std::vector<Screw>& screws,
                                  int CouplingTopology::*first,
                                  int CouplingTopology::*count,
                                  std::string (Topology::*name)(int) const) {
  std::vector<Column> columns;
  for (std::size_t c = 0; c < graph.columns.size(); ++c) {
    const CouplingTopology& coupling =
        topology.couplings[static_cast<std::size_t>(graph.columns[c])];
    for (int i = coupling.*first; i < coupling.*first + coupling.*count; ++i) {
      columns.push_back({.edge_column = static_cast<int>(c),
                         .screw = screws[static_cast<std::size_t>(i)].coordinates(),
                         .name = (topology.*name)(i)});
    }
  }
  return columns;
}

std::vector<std::string> names_of(const Expansion& side) {
  std::vector<std::string> names;
  for (const Column& column : side.columns) {
    names.push_back(column.name);
  }
  return names;
}

LabelledMatrix expanded(const Expansion& side, std::string symbol, std::string meaning) {
  const auto count = static_cast<Eigen::Index>(side.columns.size());
  MatX value(side.edges.rows(), count);
  for (Eigen::Index c = 0; c < count; ++c) {
    const Column& column = side.columns[static_cast<std::size_t>(c)];
    value.col(c) = side.edges.col(column.edge_column).cast<double>();
  }
  return {.symbol = std::move(symbol),
          .meaning = std::move(meaning),
          .value = std::move(value),
          .rows = side.edge_rows,
          .columns = names_of(side)};
}

LabelledMatrix unit_screws(const Expansion& side,
                           const CoordinateBasis& basis,
                           std::string symbol,
                           std::string meaning) {
  const auto count = static_cast<Eigen::Index>(side.columns.size());
  MatX value(basis.order(), count);
  for (Eigen::Index c = 0; c < count; ++c) {
    const Vec6& screw = side.columns[static_cast<std::size_t>(c)].screw;
    value.col(c) = basis.is_made_of_coordinates() ? VecX(basis.basis.transpose() * screw)
                                                  : basis.coordinates_of(screw);
  }
  return {.symbol = std::move(symbol),
          .meaning = std::move(meaning),
          .value = std::move(value),
          .rows = side.coordinates,
          .columns = names_of(side)};
}

// Stacks D · diag(E_i) over the rows i of the expanded edge matrix.
LabelledMatrix stacked(const LabelledMatrix& unit,
                       const LabelledMatrix& edges,
                       std::string symbol,
                       std::string meaning) {
  const Eigen::Index order = unit.value.rows();
  LabelledMatrix result{.symbol = std::move(symbol),
                        .meaning = std::move(meaning),
                        .value = MatX(order * edges.value.rows(), unit.value.cols()),
                        .rows = {},
                        .columns = unit.columns};
  for (Eigen::Index i = 0; i < edges.value.rows(); ++i) {
    result.value.middleRows(order * i, order) = unit.value * edges.value.row(i).asDiagonal();
    for (const std::string& coordinate : unit.rows) {
      result.rows.push_back(edges.rows[static_cast<std::size_t>(i)] + "." + coordinate);
    }
  }
  return result;
}

}  // namespace

std::vector<LabelledMatrix> graph_matrices(const Topology& topology, const CouplingGraph& graph) {
  std::vector<int> file_order(graph.columns.size());
  for (std::size_t e = 0; e < file_order.size(); ++e) {
    file_order[e] = static_cast<int>(e);
  }
  std::vector<std::string> bodies;
  for (const BodyTopology& body : topology.bodies) {
    bodies.push_back(body.name);
  }
  const std::vector<std::string> columns = edge_names(topology, graph.columns);
  const MatXi cutsets = cutset_matrix(graph);
  return {{.symbol = "I",
           .meaning = "incidence: +1 at the tail, -1 at the head",
           .value = incidence(graph.graph).cast<double>(),
           .rows = bodies,
           .columns = edge_names(topology, file_order)},
          {.symbol = "Q",
           .meaning = "fundamental cut-sets, one a branch",
           .value = cutsets.cast<double>(),
           .rows = edge_names(topology, graph.tree.branches),
           .columns = columns},
          {.symbol = "B",
           .meaning = "fundamental circuits, one a chord",
           .value = circuit_matrix(cutsets).cast<double>(),
           .rows = edge_names(topology, graph.tree.chords),
           .columns = columns}};
}

std::vector<LabelledMatrix> motion_matrices(const Topology& topology,
                                            const Geometry& geometry,
                                            const CouplingGraph& graph,
                                            const CoordinateBasis& basis) {
  const Expansion side{.columns = screw_columns(topology,
                                                graph,
                                                geometry.motions,
                                                &CouplingTopology::first_freedom,
                                                &CouplingTopology::freedom_count,
                                                &Topology::freedom_name),
                       .edges = circuit_matrix(cutset_matrix(graph)),
                       .edge_rows = edge_names(topology, graph.tree.chords),
                       .coordinates = row_names(basis, ScrewKind::twist)};
  LabelledMatrix B_M = expanded(side, "B_M", "circuits of the motion graph");
  LabelledMatrix M_D = unit_screws(side, basis, "M_D", "unit motions");
  LabelledMatrix M_N = stacked(M_D, B_M, "M_N", "unit motions in the network");
  return {std::move(B_M), std::move(M_D), std::move(M_N)};
}

std::vector<LabelledMatrix> action_matrices(const Topology& topology,
                                            const Geometry& geometry,
                                            const CouplingGraph& graph,
                                            const CoordinateBasis& basis) {
  const Expansion side{.columns = screw_columns(topology,
                                                graph,
                                                geometry.actions,
                                                &CouplingTopology::first_action,
                                                &CouplingTopology::action_count,
                                                &Topology::action_name),
                       .edges = cutset_matrix(graph),
                       .edge_rows = edge_names(topology, graph.tree.branches),
                       .coordinates = row_names(basis, ScrewKind::wrench)};
  LabelledMatrix Q_A = expanded(side, "Q_A", "cut-sets of the action graph");
  LabelledMatrix A_D = unit_screws(side, basis, "A_D", "unit actions");
  LabelledMatrix A_N = stacked(A_D, Q_A, "A_N", "unit actions in the network");
  return {std::move(Q_A), std::move(A_D), std::move(A_N)};
}

LabelledMatrix echelon_of(const LabelledMatrix& matrix) {
  LabelledMatrix result{.symbol = matrix.symbol + "_echelon",
                        .meaning = "reduced row echelon form of " + matrix.symbol,
                        .value = find_echelon(matrix.value).matrix,
                        .rows = {},
                        .columns = matrix.columns};
  for (Eigen::Index r = 0; r < result.value.rows(); ++r) {
    result.rows.push_back(std::to_string(r + 1));
  }
  return result;
}

std::vector<LabelledMatrix> partition_of(const LabelledMatrix& matrix,
                                         const std::vector<std::string>& primary) {
  std::vector<int> known;
  std::vector<int> unknown;
  for (std::size_t c = 0; c < matrix.columns.size(); ++c) {
    const bool is_primary = std::ranges::find(primary, matrix.columns[c]) != primary.end();
    (is_primary ? known : unknown).push_back(static_cast<int>(c));
  }
  const auto pick = [&](const std::vector<int>& columns, char side, const char* meaning) {
    LabelledMatrix part{.symbol = matrix.symbol + side,
                        .meaning = meaning,
                        .value = matrix.value(Eigen::all, columns),
                        .rows = matrix.rows,
                        .columns = {}};
    for (const int c : columns) {
      part.columns.push_back(matrix.columns[static_cast<std::size_t>(c)]);
    }
    return part;
  };
  return {pick(unknown, 'S', "columns of the secondary magnitudes"),
          pick(known, 'P', "columns of the primary magnitudes")};
}

}  // namespace kinestat
