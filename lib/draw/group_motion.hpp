// How a group of a picture moves by itself.
#pragma once

#include <vector>

#include "draw/pixel_box.hpp"

namespace kinestat {

/// The key frames of a picture that moves over and over.
struct Cycle {
  double seconds = 1.0;
  std::vector<double> times;  ///< of the key frames as shares of the cycle, rising from 0 to 1
  bool is_stepwise = false;   ///< nothing moves in between of the key frames
};

/// How a group moves in a cycle: it turns about a point of it, which shifts; in between of the key
/// frames evenly. The lists are parallel to Cycle::times.
struct GroupMotion {
  PixelPoint pivot;                ///< as drawn
  std::vector<PixelPoint> shifts;  ///< of the pivot [px]
  std::vector<double> turns;       ///< clockwise [degrees], full turns counted
};

}  // namespace kinestat
