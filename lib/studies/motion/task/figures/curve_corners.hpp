// Where a motion comes to the points of curves, at which what follows them turns sharply, and to
// those at which the law of a drive changes its acceleration.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "studies/motion/task/figures/motion_figures.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// The share of the ranges at which a motion is after so many steps, whole or not: in time where it
/// is a motion in time.
double share_at_step(const FoundMotion& motion, double step);

/// What columns have at a position, at a share of the ranges.
using ValuesAt = std::function<FigureValues(const MotionPosition& position, double share)>;

/// The places between the steps at which a curve of the mechanism, over time, a position or a
/// speed, is at one of its points, and the values before and behind a jump of a drive's
/// acceleration, in order. None of a motion that passes more than some ten
/// thousand.
std::vector<FigurePlace> find_curve_corners(const Mechanism& mechanism,
                                            const FoundMotion& motion,
                                            const MotionDetail& detail,
                                            const ValuesAt& values_at);

}  // namespace kinestat
