// The simulation that a description asks for.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/simulation/simulation.hpp"

namespace kinestat {

struct FoundSimulation {
  Mechanism mechanism;  ///< with the simulation as its only case
  SimulationPlan plan;
  MotionNetwork network;  ///< of the configurations of the rows
  std::vector<DrawnCoupling> drawn;
  SimulationSolution solution;
};

/// Empty iff there is nothing to report, with an error. Why one cannot go on is added, too.
std::optional<FoundSimulation> find_simulation(const MechanismDescription& description,
                                               Diagnostics& found);

}  // namespace kinestat
