#include "studies/motion/task/figures/poles.hpp"

#include <algorithm>

namespace kinestat {

bool may_have_poles(const MotionPlan& plan, const Mechanism& mechanism) {
  const auto is_drive = [&](int freedom) {
    return std::ranges::find(plan.drives, freedom, &PlannedDrive::freedom) != plan.drives.end();
  };
  if (plan.which < 0) {
    return false;
  }
  const Case& which = mechanism.cases[static_cast<std::size_t>(plan.which)];
  return std::ranges::any_of(which.motions,
                             [&](const Primary& known) { return !is_drive(known.index); }) ||
         std::ranges::any_of(mechanism.topology.actuators, [&](const ActuatorTopology& one) {
           return which.asks_actions && !is_drive(one.freedom);
         });
}

std::vector<double> find_poles(const FoundMotion& motion, std::span<const DeadPoint> dead_points) {
  const std::vector<double>& shares = motion.solution.shares;
  std::vector<double> poles;
  for (const DeadPoint& point : dead_points) {
    const auto row = static_cast<std::size_t>(std::max(point.step, 0));
    if (point.step >= 0 && row + 1 < shares.size()) {
      poles.push_back(point.step + (point.share - shares[row]) / (shares[row + 1] - shares[row]));
    }
  }
  return poles;
}

}  // namespace kinestat
