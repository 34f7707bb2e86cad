// The matrices of the textbook, with labels, for display and as a second way beside the node
// system.
#pragma once

#include <string>
#include <vector>

#include "graph/coupling_graph.hpp"
#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Labels travel with the numbers.
struct LabelledMatrix {
  std::string symbol;   ///< "M_N", "Q", …
  std::string meaning;  ///< a few words
  MatX value;
  std::vector<std::string> rows;
  std::vector<std::string> columns;
};

/// Incidence matrix, cut-sets Q and circuits B of the coupling graph (Cazangi 2008, 4.2, p. 72).
std::vector<LabelledMatrix> graph_matrices(const Topology& topology, const CouplingGraph& graph);

/// Columns are freedoms in the order of the graph's columns (branches, then chords): B_M, the
/// circuits with each column repeated for every freedom (in series); M_D, the unit motions in the
/// coordinates of the basis; M_N, which stacks M_D · diag(B_i) (eq. 3.31), its order·l rows named
/// circuit.coordinate. Entries are those of the geometry, whatever its units; only in an oblique
/// basis do they count in the units of the basis.
std::vector<LabelledMatrix> motion_matrices(const Topology& topology,
                                            const Geometry& geometry,
                                            const CouplingGraph& graph,
                                            const CoordinateBasis& basis);

/// Columns are actions likewise: Q_A (in parallel), A_D, and A_N, which stacks A_D · diag(Q_i)
/// (eq. 3.38), its order·k rows named cut-set.coordinate.
std::vector<LabelledMatrix> action_matrices(const Topology& topology,
                                            const Geometry& geometry,
                                            const CouplingGraph& graph,
                                            const CoordinateBasis& basis);

/// The reduced row echelon form of a network matrix; rows are numbered.
LabelledMatrix echelon_of(const LabelledMatrix& matrix);

/// The columns of secondary magnitudes (M_NS, A_NS) and those of primary ones (M_NP, A_NP), which
/// are named (eqs. 3.43, 3.47).
std::vector<LabelledMatrix> partition_of(const LabelledMatrix& matrix,
                                         const std::vector<std::string>& primary);

}  // namespace kinestat
