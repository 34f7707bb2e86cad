// A simulation, as drawings of the mechanism show it.
#pragma once

#include <cstddef>
#include <vector>

#include "draw/linkage/drawn_actions.hpp"
#include "draw/linkage/drawn_motion.hpp"
#include "studies/simulation/task/find_simulation.hpp"

namespace kinestat {

/// Where the bodies are in the rows `shown`; there must be one.
DrawnMotion make_drawn_simulation(const FoundSimulation& simulation,
                                  const std::vector<std::size_t>& shown);

/// What acts there, `drawn`, in couplings; nothing where the simulation does not report it.
DrawnActions make_drawn_actions(const FoundSimulation& simulation,
                                const std::vector<std::size_t>& shown,
                                const DrawnMotion& drawn);

}  // namespace kinestat
