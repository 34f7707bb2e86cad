#include "graph/components.hpp"

#include <algorithm>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/strong_components.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstddef>
#include <utility>

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

namespace {

using SparseGraph = boost::compressed_sparse_row_graph<boost::directedS>;

SparseGraph sparse_graph(const Digraph& graph) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  edges.reserve(graph.edges.size());
  for (const Edge& edge : graph.edges) {
    edges.emplace_back(edge.tail, edge.head);
  }
  return {boost::edges_are_unsorted_multi_pass,
          edges.begin(),
          edges.end(),
          static_cast<std::size_t>(graph.vertex_count)};
}

}  // namespace

std::vector<std::vector<int>> find_strong_components(const Digraph& graph) {
  const SparseGraph edges = sparse_graph(graph);
  std::vector<std::size_t> part_of(static_cast<std::size_t>(graph.vertex_count));
  const std::size_t count = boost::strong_components(
      edges, boost::make_iterator_property_map(part_of.begin(), get(boost::vertex_index, edges)));
  std::vector<std::vector<int>> parts(count);
  for (std::size_t v = 0; v < part_of.size(); ++v) {
    parts[part_of[v]].push_back(static_cast<int>(v));
  }
  std::erase_if(parts, [](const std::vector<int>& part) { return part.size() < 2; });
  std::ranges::sort(parts);
  return parts;
}

}  // namespace kinestat
