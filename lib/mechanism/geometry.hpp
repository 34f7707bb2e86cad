// The numbers of a mechanism in its drawn position, in flat lists beside the Topology.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "screw/wrench.hpp"

namespace kinestat {

/// Teeth that press with their coast flank where the force along the line of action is negative.
template <class Scalar>
struct OtherFlankOf {
  int action = 0;          ///< into Topology::actions
  WrenchOf<Scalar> screw;  ///< unit screw of the action on that flank
};

/// World frame, SI units. Each list is parallel to one of the Topology. Screws are written about
/// `origin`: the world origin, unless the mechanism stands far away from it. `Scalar` is double or
/// Dual; the origin and the size are plain numbers in both.
template <class Scalar>
struct GeometryOf {
  std::vector<TwistOf<Scalar>> motions;    ///< unit screw of each freedom: head relative to tail
  std::vector<WrenchOf<Scalar>> actions;   ///< unit screw of each action: of tail on head
  std::vector<Vec3Of<Scalar>> points;      ///< of each coupling [m]; the origin if it has none
  std::vector<Vec3Of<Scalar>> references;  ///< of each body, where its velocity is reported [m]
  std::vector<OtherFlankOf<Scalar>> other_flanks;
  Vec3 origin = Vec3::Zero();  ///< [m]
  double length = 1.0;         ///< size [m]: the diagonal of the box around all points
};

using Geometry = GeometryOf<double>;

/// Lets the teeth of these other flanks, given by index, press with them; a second time undoes it.
template <class Scalar>
void load_coast_flanks(const std::vector<int>& flanks, GeometryOf<Scalar>& geometry) {
  for (const int i : flanks) {
    OtherFlankOf<Scalar>& flank = geometry.other_flanks[static_cast<std::size_t>(i)];
    std::swap(geometry.actions[static_cast<std::size_t>(flank.action)], flank.screw);
  }
}

}  // namespace kinestat
