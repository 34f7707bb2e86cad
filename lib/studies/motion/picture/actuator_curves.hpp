// Pictures of what actuators have to do in a whole motion.
#pragma once

#include <string>

#include "draw/chart.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// The action of each actuator with its mean and RMS: over the position of a drive that runs
/// steadily, else over time. No charts where 'actuators' of 'dynamics' asks for none.
Figure actuator_figure(const MotionTable& motion, const std::string& title);

/// The action of each over its own speed, through the whole motion: what a motor must be able to
/// do. Likewise.
Figure speed_torque_figure(const MotionTable& motion, const std::string& title);

}  // namespace kinestat
