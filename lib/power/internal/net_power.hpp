// Power from shaft to shaft, whatever the drawing of planets and belts.
#pragma once

#include <span>
#include <vector>

#include "power/power_graph.hpp"

namespace kinestat {

/// PowerGraph::net of the arcs of all couplings. `meshes` are those of the mechanism.
std::vector<PowerArc> find_net_powers(const Mechanism& mechanism,
                                      const KinematicSolution& motion,
                                      const StaticSolution& action,
                                      std::span<const Mesh> meshes,
                                      const std::vector<PowerArc>& arcs);

}  // namespace kinestat
