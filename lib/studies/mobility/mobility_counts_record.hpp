// What reports say of the mobility: its orders, counts by Grübler, Kutzbach and Reshetov, and
// motions.
#pragma once

#include "expression/file_units.hpp"
#include "network/freedom_counts.hpp"
#include "record/record.hpp"
#include "studies/mobility/grubler.hpp"
#include "studies/mobility/mobility_counts.hpp"
#include "studies/mobility/motion_space.hpp"
#include "studies/mobility/reshetov.hpp"

namespace kinestat {

/// The three orders side by side.
const Record<MobilityCounts>& counts_record();

/// What reports say of one independent motion.
struct FreeMotionView {
  const Mechanism& mechanism;
  const FreeMotion& motion;
  const FileUnits& units;  ///< the motion is for one of them
};

const Record<FreeMotionView>& free_motion_record();

/// What reports say of the count of Grübler and Kutzbach.
struct GrublerView {
  const Topology& topology;
  const GrublerCount& count;
};

const Record<GrublerView>& grubler_record();

/// What reports say of the table of Reshetov.
struct ReshetovView {
  const Topology& topology;  ///< in space
  const ReshetovTable& table;
  std::optional<MotionCounts> exact;  ///< in space; empty without dimensions
};

const Record<ReshetovView>& reshetov_record();

}  // namespace kinestat
