// Levers (nomographs) of planetary trains: bodies on one axis whose speeds lie on a line.
#pragma once

#include <vector>

#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// A body on a lever.
struct LeverNode {
  BodyId body;
  double place = 0.0;  ///< its speed relative to the carrier, over that of the first gear found;
                       ///< the carrier has 0
};

/// The angular velocity of each node about `axis` is that of the carrier plus its place times a
/// number that all nodes share: speeds over places lie on a line (Benford and Leising 1981).
struct Lever {
  BodyId carrier;
  Vec3 axis = Vec3::UnitZ();     ///< unit vector about which the nodes turn
  std::vector<LeverNode> nodes;  ///< by place, the carrier among them
};

/// One for each set of gears that mesh in one carrier, if at least two of them turn about the line
/// on which the carrier turns itself: a Ravigneaux set has one of four nodes. Gears in fixed axes
/// have none. In the order of the couplings.
std::vector<Lever> find_levers(const Topology& topology, const Geometry& geometry);

}  // namespace kinestat
