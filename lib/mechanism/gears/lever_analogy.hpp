// Levers (nomographs) of planetary trains: bodies on one axis whose speeds lie on a line.
#pragma once

#include <vector>

#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// A body on a lever.
struct LeverNode {
  BodyId body;
  double place = 0.0;  ///< its speed relative to the carrier over that of the first gear found;
                       ///< 0 for the carrier
};

/// A lever: the angular velocity of a node about `axis` is that of the carrier plus the place of
/// the node times a number that is the same for all nodes. So the speeds over the places lie on a
/// line (Benford and Leising 1981).
struct Lever {
  BodyId carrier;
  Vec3 axis = Vec3::UnitZ();     ///< unit vector about which the nodes turn
  std::vector<LeverNode> nodes;  ///< in order of their places, with the carrier
};

/// Finds the levers, in the order of the couplings: one for each set of gears that mesh in one
/// carrier, if at least two of them turn about the axis of the carrier. A Ravigneaux set has one
/// lever with four nodes. Gears on fixed axes have none.
std::vector<Lever> find_levers(const Topology& topology, const Geometry& geometry);

}  // namespace kinestat
