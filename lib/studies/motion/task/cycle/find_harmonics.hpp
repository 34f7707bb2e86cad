// What acts along a cycle, taken apart by the turn of the drive.
#pragma once

#include <variant>
#include <vector>

#include "studies/motion/report/motion_dynamics.hpp"
#include "studies/motion/task/cycle/cycle_checks.hpp"

namespace kinestat {

/// Of the actions of drives, and of shaking and ground wrench about the world origin, up to that
/// order.
std::variant<std::vector<HarmonicSeries>, CycleProblem> find_harmonics(CycleSampler& sampler,
                                                                       int orders);

}  // namespace kinestat
