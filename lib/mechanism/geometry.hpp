// The numbers of a mechanism in its drawn position, in flat lists beside the Topology.
#pragma once

#include <vector>

#include "screw/wrench.hpp"

namespace kinestat {

/// World frame, SI units. Each list is parallel to one of the Topology.
struct Geometry {
  std::vector<Twist> motions;    ///< unit screw of each freedom: head relative to tail
  std::vector<Wrench> actions;   ///< unit screw of each action: of tail on head
  std::vector<Vec3> points;      ///< the point of each coupling [m]; the origin if it has none
  std::vector<Vec3> references;  ///< of each body, where its velocity is reported [m]
  double length = 1.0;           ///< characteristic length [m]: the largest distance between points
};

}  // namespace kinestat
