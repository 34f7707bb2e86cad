// Teeth in mesh and the body that keeps their centres apart.
#pragma once

#include <optional>
#include <vector>

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

/// Whether bodies turn about a common axis by it, so that it may be that of a gear.
bool is_hinge(CouplingType type);

/// In the order of the couplings. The axes of a gear are those of its hinges; bodies that such
/// couplings join on one line share that axis.
std::vector<Mesh> find_meshes(const Topology& topology, const Geometry& geometry);

}  // namespace kinestat
