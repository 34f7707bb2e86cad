#include "studies/motion/motion_solution.hpp"

#include "core/contract.hpp"

namespace kinestat {

std::string_view word_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::completed:
      return "completed";
    case MotionStatus::limit:
      return "limit";
    case MotionStatus::lift_off:
      return "lift-off";
    case MotionStatus::locked:
      return "locked";
    case MotionStatus::singular:
      return "singular";
    case MotionStatus::not_assembled:
      return "not assembled";
    case MotionStatus::undetermined:
      return "undetermined";
    case MotionStatus::lost_branch:
      return "lost branch";
    case MotionStatus::not_movable:
      return "not movable";
  }
  return "";
}

Configuration MotionSolution::configuration_at(int position) const {
  KINESTAT_EXPECTS(position >= 0 && position < position_count());
  const auto part = [position](const std::vector<double>& all, int count) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(position) * count;
    return std::vector<double>(first, first + count);
  };
  return {.coordinates = part(coordinates, coordinate_count), .angles = part(angles, angle_count)};
}

}  // namespace kinestat
