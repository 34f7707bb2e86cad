// The fundamental cut-sets and circuits of a graph as integer matrices.
#pragma once

#include <vector>

#include "graph/spanning_tree.hpp"

namespace kinestat {

/// The coupling graph with its tree and both matrices. Columns of both: branches, then chords, as
/// `columns` lists them; rows of Q: one cut-set a branch; rows of B: one circuit a chord.
struct CouplingGraph {
  Digraph graph;
  SpanningTree tree;
  std::vector<int> columns;  ///< edge numbers, branches first
  MatXi cutsets;             ///< Q = [I | Q_c], k x e
  MatXi circuits;            ///< B = [B_b | I], l x e

  int cutset_count() const { return static_cast<int>(tree.branches.size()); }

  int circuit_count() const { return static_cast<int>(tree.chords.size()); }
};

/// Q by row reduction of the incidence matrix, B by orthogonality: B_b = -Q_cᵀ
/// (Cazangi 2008, eqs. 4.2, 4.4 and 4.7). `tree` must be a spanning tree of `graph`.
CouplingGraph make_coupling_graph(Digraph graph, SpanningTree tree);

}  // namespace kinestat
