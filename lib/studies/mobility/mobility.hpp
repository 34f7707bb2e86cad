// How free a mechanism is and how overconstrained, and which members are to blame.
#pragma once

#include <optional>

#include "studies/mobility/grubler.hpp"
#include "studies/mobility/mobility_counts.hpp"
#include "studies/mobility/motion_space.hpp"
#include "studies/mobility/redundancy.hpp"
#include "studies/mobility/repair.hpp"
#include "studies/mobility/reshetov.hpp"

namespace kinestat {

/// What follows from the geometry.
struct ExactMobility {
  MobilityCounts counts;
  MotionSpace motions;                 ///< in the space of the file
  Redundancies spatial;                ///< what would be redundant in a machine of stiff parts
  std::optional<Redundancies> planar;  ///< where the planar order holds the motions
  Redundancies minimal;
  std::vector<Repair> repairs;  ///< of all that is redundant in space
};

/// Everything side by side. A file without dimensions has the counts only.
struct Mobility {
  GrublerCount spatial;
  std::optional<GrublerCount> planar;
  std::optional<ReshetovTable> reshetov;  ///< where the directions of the couplings are known
  std::optional<ExactMobility> exact;     ///< where their places are known
};

/// `in_space` is the same mechanism with what its couplings free and bear in space.
ExactMobility find_exact_mobility(const Mechanism& mechanism, const Mechanism& in_space);

}  // namespace kinestat
