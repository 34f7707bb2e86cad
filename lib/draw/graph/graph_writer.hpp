// Writes one graph at given places.
#pragma once

#include <vector>

#include "draw/graph/graph_model.hpp"
#include "draw/name_placer.hpp"

namespace kinestat {

/// How wide a line is for a power, between a hair and a band: proportional to it above the least.
double power_width(double size, double largest);

/// The half sizes of the box of a node.
PixelPoint node_half(const ModelNode& node);

/// Draws nodes, edges and labels; `places` are of the nodes.
void write_graph(Svg& svg, const GraphModel& model, const std::vector<PixelPoint>& places);

/// Of the same graph drawn there, in which nothing is highlighted, what this model highlights.
void write_highlights(Svg& svg, const GraphModel& model, const std::vector<PixelPoint>& places);

}  // namespace kinestat
