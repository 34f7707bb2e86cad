// A pretension that keeps cables in tension which a case would push.
#pragma once

#include <optional>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Finds the self-stress [N·m or N], one magnitude per action, that leaves no segment pushed when
/// it is added to the solution. It does not need an actuator, pushes no segment itself, and has the
/// least sum of tensions, so that one segment is just slack. Empty if there is no such self-stress,
/// or if a tension is not known.
std::optional<VecX> find_pretension(const Mechanism& mechanism,
                                    const CoordinateBasis& basis,
                                    const StaticSolution& solution);

}  // namespace kinestat
