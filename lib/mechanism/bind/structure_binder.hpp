// Bodies, couplings and actuators of a description, bound to topology, geometry and graph.
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

/// Fills topology and geometry of `result`, but not the graph.
void bind_bodies_and_couplings(const MechanismDescription& description,
                               ScrewSpaces spaces,
                               Evaluator& evaluator,
                               Diagnostics& found,
                               Mechanism& result);

/// Makes the graph with the tree that the file gives or, without one, with the tree of the first
/// couplings that close no circuit. Empty iff an error was added, because parts are not connected
/// or the given tree is not a tree.
std::optional<CouplingGraph> bind_coupling_graph(const MechanismDescription& description,
                                                 const Topology& topology,
                                                 Diagnostics& found);

}  // namespace kinestat
