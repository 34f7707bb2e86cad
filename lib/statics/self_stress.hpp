// Self-stresses: actions in equilibrium with each other alone, whose size equilibrium leaves open.
#pragma once

#include <span>
#include <vector>

#include "core/types.hpp"
#include "network/primary_check.hpp"

namespace kinestat {

/// A state of actions that needs no load. The first action has the coefficient 1; a coefficient is
/// the magnitude [N·m or N] that goes with 1 N·m or 1 N of the first.
struct SelfStress {
  std::vector<DependenceTerm> terms;
};

/// Finds a readable basis of the self-stresses that the vectors span; a vector has one magnitude
/// per action [N·m or N]. It is the reduced echelon form, in which the first action of a
/// self-stress occurs in no other. `scales`, one per action in SI, are the units in which
/// coefficients are compared with zero. Empty if there are too many self-stresses to be read.
std::vector<SelfStress> list_self_stresses(std::span<const VecX> vectors, const VecX& scales);

}  // namespace kinestat
