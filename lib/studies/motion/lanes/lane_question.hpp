// What many linkages at once are asked, and what each answers.
#pragma once

#include <optional>
#include <vector>

#include "studies/motion/lanes/lane_linkage.hpp"
#include "studies/motion/motion_solution.hpp"

namespace kinestat {

/// What is asked of a motion.
struct LaneQuestion {
  MotionDrive drive;
  int steps = 1;
  std::vector<int> places;   ///< freedoms whose positions are asked for
  std::vector<int> watched;  ///< freedoms whose dead points are looked for; none: of no freedom
  std::optional<LaneTransmission> transmission;
};

/// Of a position over the steps and the dead points [rad or m].
struct LaneExtremes {
  double least = 0.0;
  double greatest = 0.0;
  double mean = 0.0;  ///< over the way of the drive, by trapezoids
};

}  // namespace kinestat
