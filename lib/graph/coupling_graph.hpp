// The coupling graph of a mechanism with its spanning tree.
#pragma once

#include <utility>
#include <vector>

#include "graph/spanning_tree.hpp"

namespace kinestat {

/// G_C: bodies are vertices, couplings edges. `columns` lists the edges as the matrices of the
/// method do: branches first, then chords.
struct CouplingGraph {
  Digraph graph;
  SpanningTree tree;
  std::vector<int> columns;

  /// k = n - 1 of a connected graph
  int cutset_count() const { return static_cast<int>(tree.branches.size()); }

  /// l = e - n + 1 of a connected graph
  int circuit_count() const { return static_cast<int>(tree.chords.size()); }
};

/// `tree` must be a spanning tree of `graph`.
inline CouplingGraph make_coupling_graph(Digraph graph, SpanningTree tree) {
  CouplingGraph result{.graph = std::move(graph), .tree = std::move(tree), .columns = {}};
  result.columns = result.tree.branches;
  result.columns.insert(result.columns.end(), result.tree.chords.begin(), result.tree.chords.end());
  return result;
}

}  // namespace kinestat
