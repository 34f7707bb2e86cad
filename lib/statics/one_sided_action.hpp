// Actions that bodies bear in one direction only: cables pull, and surfaces that touch push.
#pragma once

#include <vector>

#include "mechanism/couplings/one_sided_actions.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The segments of cables that would have to push: their tension is negative beyond rounding.
std::vector<CouplingId> find_pushed_segments(const Mechanism& mechanism,
                                             const StaticSolution& solution);

/// The normal forces of contacts that would have to pull: they are negative beyond rounding.
std::vector<int> find_pulling_contacts(const Mechanism& mechanism, const StaticSolution& solution);

/// Whether, among these actions [N·m or N], all contacts push and all cables pull within rounding.
bool is_one_sided(const VecX& actions, const Topology& topology);

}  // namespace kinestat
