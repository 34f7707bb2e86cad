// The matrices of the textbook with labels: for display, and as a second method beside the node
// system.
#pragma once

#include <string>
#include <vector>

#include "graph/coupling_graph.hpp"
#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// A matrix with the names of its rows and columns.
struct LabelledMatrix {
  std::string symbol;   ///< "M_N", "Q", …
  std::string meaning;  ///< a few words
  MatX value;
  std::vector<std::string> rows;
  std::vector<std::string> columns;
};

/// Incidence matrix, cut-sets Q and circuits B of the coupling graph (Cazangi 2008, 4.2, p. 72).
std::vector<LabelledMatrix> graph_matrices(const Topology& topology, const CouplingGraph& graph);

/// The matrices of motions. Columns are freedoms, in the order of the columns of the graph
/// (branches, then chords). B_M is B with the column of a coupling repeated for each of its
/// freedoms (in series). M_D has the unit motions in the coordinates of the basis. M_N stacks M_D ·
/// diag(B_i) (eq. 3.31); its order·l rows are named circuit.coordinate. Entries are in the units of
/// the geometry, in an oblique basis in those of the basis.
std::vector<LabelledMatrix> motion_matrices(const Topology& topology,
                                            const Geometry& geometry,
                                            const CouplingGraph& graph,
                                            const CoordinateBasis& basis);

/// The matrices of actions, whose columns are actions in the same order. Q_A is Q with the column
/// of a coupling repeated for each of its actions (in parallel). A_D has the unit actions. A_N
/// stacks A_D · diag(Q_i) (eq. 3.38); its order·k rows are named cut-set.coordinate.
std::vector<LabelledMatrix> action_matrices(const Topology& topology,
                                            const Geometry& geometry,
                                            const CouplingGraph& graph,
                                            const CoordinateBasis& basis);

/// The reduced row echelon form of a network matrix; rows are numbered.
LabelledMatrix echelon_of(const LabelledMatrix& matrix);

/// Splits a network matrix into the columns of secondary magnitudes (M_NS, A_NS) and those of
/// primary magnitudes (M_NP, A_NP), whose names are given (eqs. 3.43, 3.47).
std::vector<LabelledMatrix> partition_of(const LabelledMatrix& matrix,
                                         const std::vector<std::string>& primary);

}  // namespace kinestat
