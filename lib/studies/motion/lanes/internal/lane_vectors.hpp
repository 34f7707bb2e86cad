// One number a lane, as the vectors of the machine.
#pragma once

#include <cstdint>

#include "studies/motion/lanes/lane_group.hpp"

namespace kinestat {

// Vectors of g++ and clang have the operators of numbers; a comparison gives all bits or none.
using LaneNumbers = double __attribute__((vector_size(kMotionLanes * sizeof(double)), may_alias));
using LaneFlags =
    std::int64_t __attribute__((vector_size(kMotionLanes * sizeof(double)), may_alias));

[[gnu::always_inline]] inline LaneNumbers& in(LaneGroup& group) {
  return reinterpret_cast<LaneNumbers&>(group);
}

[[gnu::always_inline]] inline const LaneNumbers& in(const LaneGroup& group) {
  return reinterpret_cast<const LaneNumbers&>(group);
}

[[gnu::always_inline]] inline void set_size(const LaneNumbers& from, LaneNumbers& to) {
  const LaneFlags bits = reinterpret_cast<const LaneFlags&>(from) & INT64_MAX;
  to = reinterpret_cast<const LaneNumbers&>(bits);
}

[[gnu::always_inline]] inline void choose(const LaneFlags& which,
                                          const LaneNumbers& yes,
                                          const LaneNumbers& no,
                                          LaneNumbers& to) {
  const LaneFlags bits = (which & reinterpret_cast<const LaneFlags&>(yes)) |
                         (~which & reinterpret_cast<const LaneFlags&>(no));
  to = reinterpret_cast<const LaneNumbers&>(bits);
}

}  // namespace kinestat
