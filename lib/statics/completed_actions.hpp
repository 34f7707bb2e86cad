// The actions that minimum norm or stiffness picks among those in equilibrium.
#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A choice among all actions that are in equilibrium [N·m or N]. Lists have one row per action.
struct CompletedActions {
  VecX magnitudes;            ///< in equilibrium; where open, one choice of many
  std::vector<bool> is_open;  ///< the actions that neither equilibrium nor the choice determines
  MatX measured;              ///< columns: the self-stresses whose sizes the choice determines
  MatX open;                  ///< columns: the other self-stresses; none for the minimum norm
};

/// Makes the choice that mechanism.indeterminate asks for, which must not be `report`. `particular`
/// are any actions in equilibrium, `stresses` is a basis of the self-stresses.
CompletedActions find_completed_actions(const Mechanism& mechanism,
                                        const VecX& particular,
                                        const std::vector<VecX>& stresses);

/// The scale of each action: 1 for a force, the length of the mechanism [m] for a couple.
VecX action_scales(const Mechanism& mechanism);

}  // namespace kinestat
