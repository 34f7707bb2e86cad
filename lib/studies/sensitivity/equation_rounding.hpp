// How far rates and actions may be off because the numbers of a file are rounded.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Of the rates with these indices [rad/s or m/s], by what kDataRounding does to the unit screws;
/// the solution has its rates. Those that are known keep their numbers.
std::vector<double> rate_rounding(std::span<const std::size_t> wanted,
                                  const Mechanism& mechanism,
                                  const Case& which,
                                  const KinematicSolution& motion);

/// Of such actions [N·m or N], by what it does to the unit screws, to loads and to friction, whose
/// size is taken for known; zero for those that equilibrium
/// leaves open, and for all where a cable slips, for which there is no such bound yet. The solution
/// has its magnitudes, and the mechanism the flanks on which its teeth press.
std::vector<double> action_rounding(std::span<const std::size_t> wanted,
                                    const Mechanism& mechanism,
                                    const Case& which,
                                    const StaticSolution& action);

}  // namespace kinestat
