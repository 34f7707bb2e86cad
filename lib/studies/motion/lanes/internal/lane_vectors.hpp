// One number a lane, as the vectors of the machine.
#pragma once

#include <cstdint>

#include "studies/motion/lanes/lane_follower.hpp"

namespace kinestat {

// Vectors of g++ and clang have the operators of numbers; a comparison gives all bits or none.
using LaneNumbers = double __attribute__((vector_size(kMotionLanes * sizeof(double)), may_alias));
using LaneFlags =
    std::int64_t __attribute__((vector_size(kMotionLanes * sizeof(double)), may_alias));

[[gnu::always_inline]] inline LaneNumbers& in(LaneFollower::Group& group) {
  return reinterpret_cast<LaneNumbers&>(group);
}

[[gnu::always_inline]] inline const LaneNumbers& in(const LaneFollower::Group& group) {
  return reinterpret_cast<const LaneNumbers&>(group);
}

}  // namespace kinestat
