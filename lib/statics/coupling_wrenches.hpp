// What every coupling bears, from the magnitudes of its actions.
#pragma once

#include "mechanism/mechanism.hpp"
#include "screw/bounded_screw.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// An action that is known with its bound: that of the solution, where there is one.
BoundedNumber bounded_action(const StaticSolution& solution, int action);

/// What a coupling bears, with its bounds; empty where it is open.
std::optional<BoundedWrench> bounded_wrench(const StaticSolution& solution, CouplingId coupling);

/// Makes the wrench of each coupling, tail on head, about the origin of the Geometry: the sum of
/// its unit screws, each times its magnitude, and of its friction; empty if one of its actions has
/// no value. A component that its bound does not tell from zero is zero.
void make_wrenches(const Mechanism& mechanism, StaticSolution& solution);

}  // namespace kinestat
