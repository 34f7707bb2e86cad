#include "studies/motion/task/figures/reversal_events.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/motion_tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"

namespace kinestat {

namespace {

// What differs by next to nothing of the largest value of its column does not jump.
void level_sides(const MotionTable& table, MotionEvent& event) {
  // At an end of the motion there is one side alone.
  for (std::size_t c = 0; c < std::min(event.before.size(), event.after.size()); ++c) {
    if (!event.before[c] || !event.after[c]) {
      continue;
    }
    double largest = 0.0;
    for (const MotionRow& row : table.rows) {
      largest = std::max(largest, std::abs(row.values[c].value_or(0.0)));
    }
    if (std::abs(*event.after[c] - *event.before[c]) <= kJump * largest) {
      event.after[c] = event.before[c];
    }
  }
}

}  // namespace

void add_reversals(const FoundMotion& motion,
                   std::span<const FrictionReversal> reversals,
                   std::span<const double> steps,
                   const std::function<std::vector<double>(double share)>& drives_at,
                   MotionTable& table) {
  for (const FrictionReversal& one : reversals) {
    const double beside = one.step > kSameStep ? one.step - kSameStep : one.step + kSameStep;
    std::vector<double> drive = drives_at(share_at_step(motion, one.step));
    const double apart = drives_at(share_at_step(motion, beside)).front() - drive.front();
    drive.front() = zero_within_bound(drive.front(), std::abs(apart));
    const double row = row_at(steps, one.step);
    const auto behind = std::ranges::find_if(
        table.events, [&](const MotionEvent& event) { return event.row > row; });
    const auto event =
        table.events.insert(behind,
                            {.kind = std::string(kFrictionReversalEvent),
                             .element = one.coupling,
                             .step = std::max(static_cast<int>(std::ceil(one.step)) - 1, 0),
                             .drive = drive,
                             .uncertainty = std::abs(apart),
                             .row = row,
                             .places = {},
                             .before = one.before,
                             .after = one.after});
    level_sides(table, *event);
  }
}

}  // namespace kinestat
