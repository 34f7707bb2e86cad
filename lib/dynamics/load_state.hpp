// How a mechanism stands and moves, as far as loads feel it.
#pragma once

#include <optional>
#include <vector>

#include "screw/pose.hpp"
#include "screw/twist.hpp"

namespace kinestat {

struct LoadState {
  std::vector<BodyPose> poses = {};                   ///< empty: as drawn
  std::vector<Twist> twists = {};                     ///< empty: at rest
  std::vector<std::optional<double>> positions = {};  ///< of the freedoms; empty: as drawn
  std::vector<std::optional<double>> rates = {};      ///< empty: at rest
  std::optional<double> time = 0.0;  ///< since the motion began [s]; empty: nobody knows
};

}  // namespace kinestat
