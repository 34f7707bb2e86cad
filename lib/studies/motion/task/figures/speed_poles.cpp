#include "studies/motion/task/figures/speed_poles.hpp"

#include <algorithm>

namespace kinestat {

namespace {

bool is_drive(const MotionPlan& plan, int freedom) {
  return std::ranges::find(plan.drives, freedom, &PlannedDrive::freedom) != plan.drives.end();
}

std::span<const Primary> known_motions(const MotionPlan& plan, const Mechanism& mechanism) {
  return plan.which < 0 ? std::span<const Primary>()
                        : std::span(mechanism.cases[static_cast<std::size_t>(plan.which)].motions);
}

}  // namespace

bool gives_speed_behind_drives(const MotionPlan& plan, const Mechanism& mechanism) {
  return std::ranges::any_of(known_motions(plan, mechanism),
                             [&](const Primary& known) { return !is_drive(plan, known.index); });
}

std::vector<double> find_speed_poles(const FoundMotion& motion,
                                     const Mechanism& mechanism,
                                     std::span<const DeadPoint> dead_points) {
  const std::span<const Primary> known = known_motions(motion.plan, mechanism);
  const std::vector<double>& shares = motion.solution.shares;
  std::vector<double> poles;
  for (const DeadPoint& point : dead_points) {
    const bool is_given = std::ranges::find(known, point.freedom, &Primary::index) != known.end() &&
                          !is_drive(motion.plan, point.freedom);
    const auto row = static_cast<std::size_t>(std::max(point.step, 0));
    if (is_given && point.step >= 0 && row + 1 < shares.size()) {
      poles.push_back(point.step + (point.share - shares[row]) / (shares[row + 1] - shares[row]));
    }
  }
  return poles;
}

}  // namespace kinestat
