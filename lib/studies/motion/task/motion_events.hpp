// What happens between the positions of a finite motion.
#pragma once

#include <vector>

#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// A place on the way at which a freedom comes to rest, and turns back where the motion goes on.
struct DeadPoint {
  int freedom = 0;                   ///< index into Topology::freedoms
  int step = 0;                      ///< the last position before
  double share = 0.0;                ///< of the ranges of the drives
  double uncertainty = 0.0;          ///< of the share: half of the bracket
  Configuration configuration = {};  ///< at an end of the bracket
  bool reverses = true;              ///< false where judge_reversals says so
};

struct DeadPoints {
  std::vector<DeadPoint> points;  ///< in the order of the motion
  bool may_lack_some = false;     ///< there was more to look at than the limit of work allows
};

/// How a motion ends that was found so.
MotionEnd end_of(MotionStatus status);

/// Those whose dead points are looked for.
std::vector<int> watched_freedoms(const Mechanism& mechanism, const MotionNetwork& network);

/// Of the freedoms between a body and the ground, and of those of actuators; drives have none.
/// Bracketed to kDeadPointBracket.
DeadPoints find_dead_points(const Mechanism& mechanism, const FoundMotion& motion);

}  // namespace kinestat
