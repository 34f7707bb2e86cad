// What acts in the positions of a motion that was found.
#pragma once

#include <cstddef>
#include <vector>

#include "draw/linkage/drawn_actions.hpp"
#include "draw/linkage/drawn_motion.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// What acts in the positions `shown`, at which `drawn` is, by the case of the motion: the
/// resultant forces of couplings, as columns of reactions have them, loads, actions of drives.
/// Nothing where there is no case, or it has no actions; whatever the motion reports.
DrawnActions make_drawn_actions(const MechanismDescription& description,
                                const Mechanism& mechanism,
                                const FoundMotion& motion,
                                const std::vector<std::size_t>& shown,
                                const DrawnMotion& drawn);

/// Resultants of `coupling_reactions`, each with as many positions as there are lists of them.
std::vector<ActingArrow> reaction_arrows(
    const Mechanism& mechanism,
    const std::vector<std::vector<std::optional<Vec3>>>& forces,
    const DrawnMotion& drawn);

}  // namespace kinestat
