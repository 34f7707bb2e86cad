// Bodies, couplings and actuators of a description as topology and geometry.
#pragma once

#include "mechanism/internal/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Fills the topology and the geometry, the graph excepted. `constraints` says whether couplings
/// bear what they bear in the plane or in space.
void bind_bodies_and_couplings(const MechanismDescription& description,
                               Space constraints,
                               Evaluator& evaluator,
                               Diagnostics& found,
                               Mechanism& result);

}  // namespace kinestat
