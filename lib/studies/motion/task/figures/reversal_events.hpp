// The events of friction that turns round.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "studies/motion/task/figures/motion_corners.hpp"

namespace kinestat {

/// Adds them to the events, by where they are between the rows, which stand at those steps;
/// `drives_at` answers where the drives are at a share of their ranges, in their units.
void add_reversals(const FoundMotion& motion,
                   std::span<const FrictionReversal> reversals,
                   std::span<const double> steps,
                   const std::function<std::vector<double>(double share)>& drives_at,
                   MotionTable& table);

}  // namespace kinestat
