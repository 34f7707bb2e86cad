// What happens within a step of a simulation.
#pragma once

#include <cstddef>

#include "studies/simulation/simulation.hpp"

namespace kinestat {

/// What may end a step: a goal, a stop that is struck, one that is left, sliding that comes to an
/// end, couplings that stick and give way, a cable or a contact that parts.
struct Happening {
  SimulationEvent::Kind kind = SimulationEvent::Kind::goal;
  std::size_t index = 0;  ///< of stick the friction, of slip the group; of what parts the place
                          ///< among what acts one way, contacts of cables, or arcs
  double time = 0.0;
  int sense = 0;  ///< in which a group would give way
};

}  // namespace kinestat
