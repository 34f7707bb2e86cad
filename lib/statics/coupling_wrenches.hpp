// What every coupling bears, from the magnitudes of its actions.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Of each coupling, tail on head, about the origin of the Geometry: the sum of its actions and of
/// its friction; empty if one of its actions has no value.
std::vector<std::optional<Wrench>> coupling_wrenches(const Mechanism& mechanism,
                                                     const StaticSolution& solution);

}  // namespace kinestat
