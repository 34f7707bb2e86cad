// What many linkages at once are asked, and what each answers.
#pragma once

#include <optional>
#include <vector>

#include "studies/motion/lanes/lane_linkage.hpp"
#include "studies/motion/motion_solution.hpp"

namespace kinestat {

/// Which extremes are looked for between the steps.
struct LaneSides {
  bool least = false;
  bool greatest = false;
};

/// What is asked of a motion.
struct LaneQuestion {
  MotionDrive drive;
  int steps = 1;
  std::vector<int> places;   ///< freedoms whose positions are asked for
  std::vector<int> watched;  ///< freedoms whose dead points are looked for; none: of no freedom
  std::vector<LaneSides>
      sides;                ///< of each place; of one whose dead points are known, none need be
  std::vector<bool> means;  ///< of each place, whether its mean is asked for
  std::optional<LaneTransmission> transmission;
  LaneSides transmission_sides;
};

/// Of a position over the steps, the dead points and, where asked for, between them [rad or m].
struct LaneExtremes {
  double least = 0.0;
  double greatest = 0.0;
  double mean = 0.0;  ///< over the way of the drive, where asked for
};

}  // namespace kinestat
