// A spanning tree: its branches cut the graph, the other edges, the chords, close circuits.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "graph/digraph.hpp"

namespace kinestat {

/// Edge numbers; branches in the order in which they were chosen, chords in file order.
struct SpanningTree {
  std::vector<int> branches;
  std::vector<int> chords;
};

/// The first edges, in file order, that close no circuit: what row reduction of the incidence
/// matrix picks from left to right (Cazangi 2008, section 4.2, p. 72). Empty if the graph is not
/// connected.
std::optional<SpanningTree> find_spanning_tree(const Digraph& graph);

/// The tree with the given branches, in the given order. Empty if they are no spanning tree.
std::optional<SpanningTree> find_spanning_tree(const Digraph& graph, std::span<const int> branches);

}  // namespace kinestat
