// The coupling graph of a file and its spanning tree.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "graph/coupling_graph.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// The graph with the tree of the file or, where it gives none, of the first couplings that close
/// no circuit. Empty iff an error was added: parts that nothing joins, or a tree that is none.
std::optional<CouplingGraph> bind_coupling_graph(const MechanismDescription& description,
                                                 const Topology& topology,
                                                 Diagnostics& found);

}  // namespace kinestat
