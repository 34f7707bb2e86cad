// Pictures of a simulation over time.
#pragma once

#include <string>

#include "draw/chart.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// What the rows have beside energies, a chart a quantity and unit; what never changes is left out.
/// `simulation` is of simulation_table, as below.
Figure simulation_figure(const MotionTable& simulation, const std::string& title);

/// Kinetic and potential energy, and what was supplied and lost, in one chart.
Figure energy_figure(const MotionTable& simulation, const std::string& title);

}  // namespace kinestat
