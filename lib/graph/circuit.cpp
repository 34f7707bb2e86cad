#include "graph/circuit.hpp"

#include <algorithm>

namespace kinestat {

namespace {

// The tree as ways to its first vertex.
struct Climb {
  std::vector<int> branch;  ///< of each vertex, towards the first one; -1 there
  std::vector<int> parent;
  std::vector<int> depth;
};

Climb climb_of(const CouplingGraph& graph) {
  const auto count = static_cast<std::size_t>(graph.graph.vertex_count);
  std::vector<std::vector<int>> branches(count);
  for (const int b : graph.tree.branches) {
    const Edge& edge = graph.graph.edges[static_cast<std::size_t>(b)];
    branches[static_cast<std::size_t>(edge.tail)].push_back(b);
    branches[static_cast<std::size_t>(edge.head)].push_back(b);
  }
  Climb climb{.branch = std::vector<int>(count, -1),
              .parent = std::vector<int>(count, -1),
              .depth = std::vector<int>(count, 0)};
  std::vector<int> waiting = {0};
  for (std::size_t next = 0; next < waiting.size(); ++next) {
    const auto from = static_cast<std::size_t>(waiting[next]);
    for (const int b : branches[from]) {
      const Edge& edge = graph.graph.edges[static_cast<std::size_t>(b)];
      const int other = edge.tail == waiting[next] ? edge.head : edge.tail;
      if (b != climb.branch[from]) {
        const auto to = static_cast<std::size_t>(other);
        climb.branch[to] = b;
        climb.parent[to] = waiting[next];
        climb.depth[to] = climb.depth[from] + 1;
        waiting.push_back(other);
      }
    }
  }
  return climb;
}

// From the chord's head back to its tail through the tree.
Circuit circuit_of(const CouplingGraph& graph, const Climb& climb, int chord) {
  Circuit circuit{.chord = {chord}, .edges = {{.coupling = {chord}, .sign = 1}}};
  const Edge& edge = graph.graph.edges[static_cast<std::size_t>(chord)];
  std::vector<CircuitEdge> down;
  int from = edge.head;
  int to = edge.tail;
  const auto climb_once = [&](int& vertex, std::vector<CircuitEdge>& edges, int upwards) {
    const auto v = static_cast<std::size_t>(vertex);
    const int branch = climb.branch[v];
    const bool leaves_tail = graph.graph.edges[static_cast<std::size_t>(branch)].tail == vertex;
    edges.push_back({.coupling = {branch}, .sign = leaves_tail ? upwards : -upwards});
    vertex = climb.parent[v];
  };
  while (from != to) {
    if (climb.depth[static_cast<std::size_t>(from)] >= climb.depth[static_cast<std::size_t>(to)]) {
      climb_once(from, circuit.edges, 1);
    } else {
      climb_once(to, down, -1);
    }
  }
  circuit.edges.insert(circuit.edges.end(), down.rbegin(), down.rend());
  return circuit;
}

}  // namespace

std::vector<Circuit> find_circuits(const CouplingGraph& graph) {
  std::vector<Circuit> circuits;
  if (graph.tree.chords.empty()) {
    return circuits;
  }
  const Climb climb = climb_of(graph);
  for (const int chord : graph.tree.chords) {
    circuits.push_back(circuit_of(graph, climb, chord));
  }
  return circuits;
}

}  // namespace kinestat
