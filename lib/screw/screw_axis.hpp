// The screw (pt: helicoide) of a twist or wrench: its axis and its pitch.
#pragma once

#include <optional>

#include "screw/wrench.hpp"

namespace kinestat {

/// A line with a pitch. A pure translation or couple has no line: `point` and `pitch` are then
/// empty, which stands for infinite pitch.
struct ScrewAxis {
  Vec3 direction = Vec3::Zero();  ///< unit vector along ω or F, or along v or T for infinite pitch
  std::optional<Vec3> point;      ///< the point of the axis next to the world origin [m]
  std::optional<double> pitch;    ///< [m/rad] or [N·m/N]
};

/// The instantaneous screw axis of a motion; empty for a body at rest. `length` [m], the size of
/// the mechanism, weighs rotation against translation.
std::optional<ScrewAxis> find_axis(const Twist& twist, double length);

/// The central axis of an action; empty where there is no action.
std::optional<ScrewAxis> find_axis(const Wrench& wrench, double length);

}  // namespace kinestat
