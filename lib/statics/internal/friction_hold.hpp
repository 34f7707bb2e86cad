// Known actions that nothing but friction holds.
#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/internal/friction_loads.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Where equilibrium without friction contradicts one known action, as at a dead centre: all
/// actions [N·m or N] in the equilibria in which another action, unknown in its place, presses one
/// way or the other so hard that friction holds what is known. Empty where actions stay open, or no
/// such equilibrium has surfaces that push and cables that pull.
std::vector<VecX> find_held_by_friction(const Mechanism& mechanism,
                                        const CoordinateBasis& basis,
                                        const FrictionLoads& given,
                                        const StaticSolution& frictionless);

}  // namespace kinestat
