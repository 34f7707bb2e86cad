// The connected parts of a graph, directions ignored.
#pragma once

#include <vector>

#include "graph/digraph.hpp"

namespace kinestat {

/// The vertices of each part, ascending; parts in the order of their first vertex. One part means
/// that the graph is connected; a graph without vertices has none.
std::vector<std::vector<int>> find_components(const Digraph& graph);

}  // namespace kinestat
