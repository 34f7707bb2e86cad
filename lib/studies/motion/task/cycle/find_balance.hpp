// Counterweights against the shaking force of a motion.
#pragma once

#include <span>
#include <variant>

#include "mechanism/dynamics_plan.hpp"
#include "studies/motion/report/motion_dynamics.hpp"
#include "studies/motion/task/cycle/cycle_checks.hpp"

namespace kinestat {

/// What bodies that turn about an axis of the ground must carry, as mass times place, so that the
/// mean square of the shaking force in time is least. Of counterweights that do the same, the first
/// body has it.
std::variant<BalanceFigures, CycleProblem> find_balance(CycleSampler& sampler,
                                                        std::span<const CounterweightPlan> plan);

}  // namespace kinestat
