// Actions that bodies bear in one direction only: cables pull, surfaces that touch push, freewheels
// hold one torque.
#pragma once

#include <optional>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/couplings/one_sided_actions.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The segments of cables that would have to push: their tension is negative beyond rounding.
std::vector<CouplingId> find_pushed_segments(const Mechanism& mechanism,
                                             const StaticSolution& solution);

/// The normal forces of contacts that would have to pull: they are negative beyond rounding.
std::vector<int> find_pulling_contacts(const Mechanism& mechanism, const StaticSolution& solution);

/// A freewheel that an answer asks for what it cannot do.
struct WrongFreewheel {
  CouplingId coupling;
  FreewheelFault fault = FreewheelFault::overruns;
  double value = 0.0;  ///< the torque [N·m] or the slip [rad/s] that it asks for
};

/// By what is known of the motion and the actions beyond rounding; either may be empty.
std::vector<WrongFreewheel> find_wrong_freewheels(const Mechanism& mechanism,
                                                  const std::optional<KinematicSolution>& motion,
                                                  const std::optional<StaticSolution>& action);

/// Whether, among these actions [N·m or N], all contacts push and all cables pull within rounding.
bool is_one_sided(const VecX& actions, const Topology& topology);

}  // namespace kinestat
