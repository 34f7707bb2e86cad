// The fundamental cut-sets and circuits of a graph as integer matrices, for display and for tests.
#pragma once

#include "graph/coupling_graph.hpp"

namespace kinestat {

/// Q = [I | Q_c], k x e: one row a branch, columns as the graph lists them, by row reduction of the
/// incidence matrix (Cazangi 2008, eq. 4.2). Dense: it costs k² e.
MatXi cutset_matrix(const CouplingGraph& graph);

/// B = [B_b | I], l x e: one row a chord, from Q by orthogonality, B_b = -Q_cᵀ
/// (Cazangi 2008, eqs. 4.4 and 4.7). `cutsets` is Q of the same graph.
MatXi circuit_matrix(const MatXi& cutsets);

}  // namespace kinestat
