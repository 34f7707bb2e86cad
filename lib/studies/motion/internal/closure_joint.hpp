// A joint of a network as its closure needs it.
#pragma once

#include "couplings/finite_law.hpp"

namespace kinestat {

/// Lengths in sizes of the mechanism. One without a coordinate slides by its direction, once.
struct ClosureJoint {
  ElementaryKind kind = ElementaryKind::turn;
  int parent = 0;
  Vec3 direction = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();
  double pitch = 0.0;
  double sense = 1.0;
  int coordinate = -1;
  int rate = -1;
};

}  // namespace kinestat
