// Teeth in mesh and the body that keeps their centres apart.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/gears/hinge_lines.hpp"
#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// A coupling of type gear or bevel_gear. Seen from its carrier both gears turn about fixed axes,
/// so that only what turns there rolls; in a train with fixed axes the carrier is the ground.
struct Mesh {
  CouplingId coupling;
  std::optional<BodyId> carrier;  ///< none where the axes of the two have no body, or several, in
                                  ///< common
};

/// In the order of the couplings. The axes of a gear are the lines of its hinges.
std::vector<Mesh> find_meshes(const Topology& topology, const Geometry& geometry);

}  // namespace kinestat
