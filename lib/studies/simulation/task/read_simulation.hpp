// The section `simulation` in numbers.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/simulation/simulation_plan.hpp"

namespace kinestat {

/// The description with the simulation as its only case, and without what else it asks for.
MechanismDescription simulated_description(const MechanismDescription& description);

/// Of such a description, bound to this mechanism. Empty iff an error was added: names of no
/// freedom, what is given twice or not at all, what a simulation does not know.
std::optional<SimulationPlan> read_simulation(const MechanismDescription& description,
                                              const Mechanism& mechanism,
                                              Diagnostics& found);

}  // namespace kinestat
