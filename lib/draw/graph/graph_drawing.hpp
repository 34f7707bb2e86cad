// Pictures of graphs: coupling, motion and action graph, circuits, cut-sets, power flow; and DOT.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/graph/graph_model.hpp"
#include "draw/picture.hpp"

namespace kinestat {

/// One graph. Branches are full and thick, chords dashed; arrows point from tail to head. With
/// power, they point where it goes, as wide as it is large; what goes in circles has a double line.
/// The layout is the same in every run, and the same for all models of one graph.
Picture draw_graph(const GraphModel& model);

/// The same graph with other edges highlighted, side by side under the title of all. Empty without
/// models.
std::optional<Picture> draw_graphs(const std::vector<GraphModel>& models, std::string title);

/// The graph in the language DOT: branches full, chords dashed, what is highlighted thick; with
/// power, edges point where it goes, and ports are nodes of their own.
std::string dot_text(const GraphModel& model);

}  // namespace kinestat
