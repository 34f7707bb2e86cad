// Meshes of gears with their carriers.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/gears/hinge_lines.hpp"
#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// A coupling of type gear or bevel_gear. Both gears turn about axes that are fixed in its carrier.
/// In a train with fixed axes, the carrier is the ground.
struct Mesh {
  CouplingId coupling;
  std::optional<BodyId> carrier;  ///< empty if the axes of both gears have no body, or several,
                                  ///< in common
};

/// Finds the meshes, in the order of the couplings. The axes of a gear are the lines of its hinges.
std::vector<Mesh> find_meshes(const Topology& topology, const Geometry& geometry);

}  // namespace kinestat
