// Bodies, couplings and actuators of a description as topology and geometry.
#pragma once

#include "mechanism/internal/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Whether couplings free what they free in the plane or in space, and bear what they bear there.
struct ScrewSpaces {
  Space motions = Space::spatial;
  Space actions = Space::spatial;
};

/// Fills the topology and the geometry, the graph excepted.
void bind_bodies_and_couplings(const MechanismDescription& description,
                               ScrewSpaces spaces,
                               Evaluator& evaluator,
                               Diagnostics& found,
                               Mechanism& result);

}  // namespace kinestat
