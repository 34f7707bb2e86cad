#include "graph/spanning_tree.hpp"

#include <numeric>

#include "graph/internal/disjoint_sets.hpp"

namespace kinestat {

namespace {

// Takes the edges in the given order; an edge that closes a circuit is left out.
std::vector<int> grow(const Digraph& graph, std::span<const int> order) {
  DisjointSets sets(graph.vertex_count);
  std::vector<int> branches;
  for (const int e : order) {
    const Edge& edge = graph.edges[static_cast<std::size_t>(e)];
    if (sets.join(edge.tail, edge.head)) {
      branches.push_back(e);
    }
  }
  return branches;
}

std::vector<int> all_edges(const Digraph& graph) {
  std::vector<int> order(graph.edges.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::optional<SpanningTree> complete(const Digraph& graph, std::vector<int> branches) {
  if (static_cast<int>(branches.size()) != graph.vertex_count - 1) {
    return std::nullopt;
  }
  std::vector<bool> is_branch(graph.edges.size(), false);
  for (const int e : branches) {
    is_branch[static_cast<std::size_t>(e)] = true;
  }
  SpanningTree tree;
  tree.branches = std::move(branches);
  for (int e = 0; e < graph.edge_count(); ++e) {
    if (!is_branch[static_cast<std::size_t>(e)]) {
      tree.chords.push_back(e);
    }
  }
  return tree;
}

}  // namespace

std::optional<SpanningTree> find_spanning_tree(const Digraph& graph) {
  return complete(graph, grow(graph, all_edges(graph)));
}

std::optional<SpanningTree> find_spanning_tree(const Digraph& graph,
                                               std::span<const int> branches) {
  std::vector<int> grown = grow(graph, branches);
  if (grown.size() != branches.size()) {
    return std::nullopt;
  }
  return complete(graph, std::move(grown));
}

}  // namespace kinestat
