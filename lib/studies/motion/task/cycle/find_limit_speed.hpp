// The speed at which contacts part and cables slacken.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "mechanism/dynamics_plan.hpp"
#include "studies/motion/report/motion_dynamics.hpp"
#include "studies/motion/task/cycle/cycle_checks.hpp"

namespace kinestat {

/// Of each coupling the steady speed of the drive at which its force is zero somewhere on the way,
/// and is positive below it: without friction and dampers each force is A + B w^2, A and B being
/// functions of the position alone.
std::variant<std::vector<LimitSpeed>, CycleProblem> find_limit_speeds(
    CycleSampler& sampler, std::span<const LimitedCoupling> plan);

}  // namespace kinestat
