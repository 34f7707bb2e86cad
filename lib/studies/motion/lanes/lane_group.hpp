// One number of each of many linkages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kinestat {

/// So many linkages at once: wider vectors are compared one number after the other on machines
/// that do not have them.
inline constexpr std::size_t kMotionLanes = 4;

struct alignas(kMotionLanes * sizeof(double)) LaneGroup {
  double numbers[kMotionLanes] = {};

  bool is_zero() const {
    return std::ranges::all_of(numbers, [](double one) { return one == 0.0; });
  }
};

using LaneGroups = std::vector<LaneGroup>;

}  // namespace kinestat
