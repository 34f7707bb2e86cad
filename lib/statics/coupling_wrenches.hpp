// What every coupling bears, from the magnitudes of its actions.
#pragma once

#include "mechanism/mechanism.hpp"
#include "screw/bounded_screw.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The magnitude of an action with its error bound; the action must have a value. If the solution
/// has no bounds, the bound is the rounding of the magnitude itself.
BoundedNumber bounded_action(const StaticSolution& solution, int action);

/// The wrench that a coupling bears, with its error bounds; empty if it is not determined.
std::optional<BoundedWrench> bounded_wrench(const StaticSolution& solution, CouplingId coupling);

/// Computes the wrench of each coupling, of tail on head, about the origin of the Geometry: the sum
/// of its unit screws times their magnitudes, and of its friction. It is empty if one of the
/// actions has no value. A component that is not larger than its error bound becomes zero.
void make_wrenches(const Mechanism& mechanism, StaticSolution& solution);

}  // namespace kinestat
