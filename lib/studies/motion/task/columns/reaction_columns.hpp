// The columns of a motion that say what couplings bear, whatever its direction.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/couplings/coupling_reactions.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// Of each coupling that bears forces their resultant with its friction [N]: without those of
/// actuators on it, of central hinges without the planets' part, of planets that of the most loaded
/// one. Of each with friction its couple [N·m] or drag [N], and the power that it loses [W].
std::vector<MotionReading> reaction_readings(const FileUnits& units, const Mechanism& mechanism);

/// What each of `coupling_reactions` bears at a position: of tail on head [N]; empty where actions
/// are unknown.
std::vector<std::optional<Vec3>> reaction_forces(const std::vector<CouplingReaction>& reactions,
                                                 const Topology& topology,
                                                 const MotionPosition& position);

}  // namespace kinestat
