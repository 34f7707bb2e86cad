// The actions that minimum norm or stiffness picks among those in equilibrium.
#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// All in N·m and N, one row an action.
struct CompletedActions {
  VecX magnitudes;            ///< in equilibrium; where open, one choice of many
  std::vector<bool> is_open;  ///< what neither equilibrium nor the choice determines
  MatX measured;  ///< self-stresses in columns, the sizes of which the choice determines
  MatX open;      ///< those it does not see, with which they span all; none for the minimum norm
};

/// What mechanism.indeterminate asks for, which is not `report`: `particular` are any actions in
/// equilibrium, `stresses` a basis of the self-stresses.
CompletedActions find_completed_actions(const Mechanism& mechanism,
                                        const VecX& particular,
                                        const std::vector<VecX>& stresses);

/// Of each action: 1 for a force, the mechanism's length for a couple [SI].
VecX action_scales(const Mechanism& mechanism);

}  // namespace kinestat
