#include "studies/motion/task/figures/motion_steps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/motion_tolerance.hpp"

namespace kinestat {

double step_of_row(const FoundMotion& motion, std::size_t row) {
  const bool is_last = row + 1 == motion.solution.shares.size();
  return motion.plan.schedule && is_last
             ? motion.plan.schedule->time_at(motion.solution.shares[row]) * motion.plan.steps
             : static_cast<double>(row);
}

std::optional<double> time_of_row(const FoundMotion& motion, std::size_t row) {
  if (!motion.plan.schedule) {
    return std::nullopt;
  }
  const double time = static_cast<double>(row) / static_cast<double>(motion.plan.steps);
  const bool is_step = motion.solution.shares[row] == motion.plan.schedule->share_at(time);
  return is_step ? std::optional(time) : std::nullopt;
}

double share_at_step(const FoundMotion& motion, double step) {
  if (motion.plan.schedule) {
    return motion.plan.schedule->share_at(step / motion.plan.steps);
  }
  const std::vector<double>& shares = motion.solution.shares;
  const auto row = static_cast<std::size_t>(step);
  return row + 1 < shares.size() ? std::lerp(shares[row], shares[row + 1], step - std::floor(step))
                                 : shares.back();
}

double step_at_share(const FoundMotion& motion, double share) {
  if (motion.plan.schedule) {
    return motion.plan.schedule->time_at(share) * motion.plan.steps;
  }
  return row_at(motion.solution.shares, share);
}

double nearest_row(double step) {
  return std::abs(step - std::round(step)) < kSameStep ? std::round(step) : step;
}

double row_at(std::span<const double> steps, double step) {
  const auto behind = std::ranges::upper_bound(steps, step);
  if (behind == steps.begin() || behind == steps.end()) {
    return behind == steps.begin() ? 0.0 : static_cast<double>(steps.size() - 1);
  }
  const double before = *std::prev(behind);
  return static_cast<double>(behind - steps.begin() - 1) + (step - before) / (*behind - before);
}

}  // namespace kinestat
