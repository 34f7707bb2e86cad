// The rows of a simulation as those of a motion, whose only drive is time.
#pragma once

#include "studies/motion/report/motion_table.hpp"
#include "studies/simulation/report/simulation_record.hpp"

namespace kinestat {

/// For what draws and plays motions.
MotionTable simulation_table(const SimulationReportView& view);

}  // namespace kinestat
