// Pictures of what a motion with inertia tells as a whole.
#pragma once

#include <string>

#include "draw/chart.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// The shaking force as its tip runs over the frame, y over x, and z over x where that changes:
/// where counterweights are asked for without and with them. No charts without such a force.
Figure shaking_figure(const MotionTable& motion, const std::string& title);

/// Amplitudes over their orders, a chart a unit. No charts where none are asked for.
Figure harmonic_figure(const MotionTable& motion, const std::string& title);

}  // namespace kinestat
