// The parts of a graph that hang together: directions ignored, and along them.
#pragma once

#include <vector>

#include "graph/digraph.hpp"

namespace kinestat {

/// Directions ignored, the vertices of each part, ascending; parts in the order of their first
/// vertex. One part means that the graph is connected; a graph without vertices has none.
std::vector<std::vector<int>> find_components(const Digraph& graph);

/// The parts within which every vertex reaches every other, of those that have a cycle of two
/// vertices or more: their vertices, ascending; parts in the order of their first vertex (Tarjan
/// 1972). In a flow of power these are the circulations.
std::vector<std::vector<int>> find_strong_components(const Digraph& graph);

}  // namespace kinestat
