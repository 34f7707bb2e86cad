#include "graph/components.hpp"

#include "graph/internal/disjoint_sets.hpp"

namespace kinestat {

std::vector<std::vector<int>> find_components(const Digraph& graph) {
  DisjointSets sets(graph.vertex_count);
  for (const Edge& edge : graph.edges) {
    sets.join(edge.tail, edge.head);
  }
  std::vector<std::vector<int>> parts;
  std::vector<int> part_of(static_cast<std::size_t>(graph.vertex_count), -1);
  for (int v = 0; v < graph.vertex_count; ++v) {
    int& part = part_of[static_cast<std::size_t>(sets.root(v))];
    if (part < 0) {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[static_cast<std::size_t>(part)].push_back(v);
  }
  return parts;
}

}  // namespace kinestat
