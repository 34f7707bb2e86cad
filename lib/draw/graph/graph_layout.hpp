// Where the nodes of a graph stand so that it can be read.
#pragma once

#include <vector>

#include "draw/svg.hpp"
#include "graph/digraph.hpp"

namespace kinestat {

/// How well a layout can be read; less is better.
struct LayoutFaults {
  int crossings = 0;      ///< pairs of edges that cross
  int covered_nodes = 0;  ///< pairs of a node and an edge that passes too near to it
};

/// A place for each vertex [px], none closer to another than `distance`. Vertex 0, the ground, is
/// special: of some layouts, with the ground within the others or among them on a circle, that is
/// taken which has the fewest crossings and edges across nodes. The same in every run.
std::vector<PixelPoint> lay_out(const Digraph& graph, double distance);

LayoutFaults find_faults(const Digraph& graph,
                         const std::vector<PixelPoint>& places,
                         double node_radius);

}  // namespace kinestat
