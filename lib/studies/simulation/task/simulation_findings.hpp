// How a simulation ended, in messages.
#pragma once

#include "core/diagnostic.hpp"
#include "studies/simulation/task/find_simulation.hpp"

namespace kinestat {

/// What it did not reach, what parted, what nothing determines, and why it could not go on.
void add_simulation_findings(const FoundSimulation& simulation,
                             const MechanismDescription& description,
                             Diagnostics& found);

}  // namespace kinestat
