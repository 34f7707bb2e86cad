// What many linkages look for between the steps of their motions.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "studies/motion/lanes/lane_group.hpp"
#include "studies/motion/lanes/lane_question.hpp"
#include "studies/motion/peak_search.hpp"

namespace kinestat {

/// An angle of transmission.
struct LaneAngle {
  LaneGroup share;  ///< its squared sine
  LaneGroup along;
  LaneGroup across;
};

/// An extreme that is looked for.
struct LaneTarget {
  std::size_t place = 0;  ///< of the question; behind all places: the transmission angle
  double sign = 1.0;      ///< -1: the least
};

struct LaneExtremeTargets {
  struct Climb {
    LaneTarget target;
    PeakSearch search;
  };

  std::vector<LaneTarget> targets;
  std::vector<LaneGroups> values;  ///< of each place that is a target, at the steps
  std::vector<LaneAngle> angles;   ///< likewise
  std::array<std::vector<Climb>, kMotionLanes> of_lane;  ///< the last one is under way

  /// Those of a question.
  explicit LaneExtremeTargets(const LaneQuestion& question);

 private:
  void add(std::size_t place, const LaneSides& sides);
};

}  // namespace kinestat
