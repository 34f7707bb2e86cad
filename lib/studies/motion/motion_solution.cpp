#include "studies/motion/motion_solution.hpp"

#include "core/contract.hpp"

namespace kinestat {

Configuration MotionSolution::configuration_at(int position) const {
  KINESTAT_EXPECTS(position >= 0 && position < position_count());
  const auto part = [position](const std::vector<double>& all, int count) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(position) * count;
    return std::vector<double>(first, first + count);
  };
  return {.coordinates = part(coordinates, coordinate_count), .angles = part(angles, angle_count)};
}

}  // namespace kinestat
