// Graphs as text for Graphviz.
#pragma once

#include <string>

#include "draw/graph/graph_model.hpp"

namespace kinestat {

/// The graph in the language DOT: branches full, chords dashed, what is highlighted thick; with
/// power, edges point where it goes, and ports are nodes of their own.
std::string dot_text(const GraphModel& model);

}  // namespace kinestat
