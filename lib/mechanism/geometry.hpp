// The numbers of a mechanism in its drawn position, in flat lists beside the Topology.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "screw/wrench.hpp"

namespace kinestat {

/// The coast flank of a mesh, on which teeth press if the force along the line of action is
/// negative.
template <class Scalar>
struct OtherFlankOf {
  int action = 0;          ///< into Topology::actions
  WrenchOf<Scalar> screw;  ///< unit screw of the action on that flank
};

/// The numbers of a mechanism in SI units, along the axes of the world. Each list is parallel to
/// one of the Topology. Points are measured from `origin`, and screws are written about it.
/// `Scalar` is double or Dual; the origin and the size are plain numbers in both cases.
template <class Scalar>
struct GeometryOf {
  std::vector<TwistOf<Scalar>> motions;    ///< unit screw of each freedom: head relative to tail
  std::vector<WrenchOf<Scalar>> actions;   ///< unit screw of each action: of tail on head
  std::vector<Vec3Of<Scalar>> points;      ///< of each coupling [m]; zero if it has none
  std::vector<Vec3Of<Scalar>> references;  ///< of each body, where its velocity is reported [m]
  std::vector<OtherFlankOf<Scalar>> other_flanks;
  LocalOrigin origin;
  double length = 1.0;  ///< size [m]: the diagonal of the box around all points
};

using Geometry = GeometryOf<double>;

/// Makes teeth press on their coast flanks, which are indices into `other_flanks`. A second call
/// with the same flanks undoes this.
template <class Scalar>
void load_coast_flanks(const std::vector<int>& flanks, GeometryOf<Scalar>& geometry) {
  for (const int i : flanks) {
    OtherFlankOf<Scalar>& flank = geometry.other_flanks[static_cast<std::size_t>(i)];
    std::swap(geometry.actions[static_cast<std::size_t>(flank.action)], flank.screw);
  }
}

}  // namespace kinestat
