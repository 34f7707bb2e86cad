// Bodies, couplings and actuators of a description as topology, geometry and graph.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "graph/coupling_graph.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/couplings/internal/screw_binder.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Fills the topology and the geometry, the graph excepted.
void bind_bodies_and_couplings(const MechanismDescription& description,
                               ScrewSpaces spaces,
                               Evaluator& evaluator,
                               Diagnostics& found,
                               Mechanism& result);

/// The graph with the tree of the file or, where it gives none, of the first couplings that close
/// no circuit. Empty iff an error was added: parts that nothing joins, or a tree that is none.
std::optional<CouplingGraph> bind_coupling_graph(const MechanismDescription& description,
                                                 const Topology& topology,
                                                 Diagnostics& found);

}  // namespace kinestat
