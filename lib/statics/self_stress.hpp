// Actions in equilibrium with each other alone, which equilibrium leaves open.
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

/// The readable basis of the states that the vectors span, one magnitude an action [N·m or N]: the
/// reduced echelon form, in which each first action stands in no other state. Coefficients are
/// weighed in `scales` (SI, one an action) where they count as zero. Empty if there are so many
/// that nobody would read them.
std::vector<SelfStress> list_self_stresses(std::span<const VecX> vectors, const VecX& scales);

}  // namespace kinestat
