// What would keep cables in tension that a case pushes.
#pragma once

#include <optional>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The actions [N·m or N], one an action, that keep every segment from being pushed when they are
/// added: the self-stress without an actuator that pulls or leaves alone every segment and whose
/// sum of tensions is least. A segment is then just slack. Empty where no self-stress does, or if a
/// force is not known.
std::optional<VecX> find_pretension(const Mechanism& mechanism,
                                    const CoordinateBasis& basis,
                                    const StaticSolution& solution);

}  // namespace kinestat
