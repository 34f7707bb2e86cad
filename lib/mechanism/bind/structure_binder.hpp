// Bodies, couplings and actuators of a description as topology and geometry.
#pragma once

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/couplings/internal/screw_binder.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Fills the topology and the geometry, the graph excepted.
void bind_bodies_and_couplings(const MechanismDescription& description,
                               ScrewSpaces spaces,
                               Evaluator& evaluator,
                               Diagnostics& found,
                               Mechanism& result);

}  // namespace kinestat
