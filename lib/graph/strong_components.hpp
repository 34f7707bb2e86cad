// The parts of a directed graph within which every vertex reaches every other.
#pragma once

#include <vector>

#include "graph/digraph.hpp"

namespace kinestat {

/// The vertices of each part that has a cycle of two vertices or more, ascending; parts in the
/// order of their first vertex (Tarjan 1972). In a flow of power these are the circulations.
std::vector<std::vector<int>> find_strong_components(const Digraph& graph);

}  // namespace kinestat
