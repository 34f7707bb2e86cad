// The degrees of freedom and of constraint in the minimal, the planar and the spatial order.
#pragma once

#include <optional>

#include "math/elimination/rank.hpp"
#include "network/freedom_counts.hpp"

namespace kinestat {

/// Both sides in one order.
struct SideCounts {
  MotionCounts motions;
  std::optional<ActionCounts> actions;  ///< empty where nobody asked, or the order cannot hold them
};

/// Side by side, because a planar linkage is perfectly constrained in its plane and overconstrained
/// in space. `planar` is empty where some motion or action leaves the plane.
struct MobilityCounts {
  SideCounts minimal;
  std::optional<SideCounts> planar;
  SideCounts spatial;
  RankEvidence evidence;  ///< of the velocity system in the minimal order
};

/// Counts the motions. One elimination serves all orders, unless couplings free more in space.
/// `in_space` is the same mechanism with what its couplings free and bear in space; for a mechanism
/// that frees the same there it may be the same object.
MobilityCounts count_motions(const Mechanism& mechanism, const Mechanism& in_space);

/// Adds the counts of the actions; `in_space` likewise, but for the constraints.
void count_actions(const Mechanism& mechanism, const Mechanism& in_space, MobilityCounts& counts);

}  // namespace kinestat
