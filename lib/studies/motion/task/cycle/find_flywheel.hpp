// The flywheel that keeps a cycle nearly steady.
#pragma once

#include <variant>

#include "mechanism/dynamics_plan.hpp"
#include "studies/motion/report/motion_dynamics.hpp"
#include "studies/motion/task/cycle/cycle_checks.hpp"

namespace kinestat {

/// By the energy that the drive gives too much and too little on its way (Norton, Design of
/// Machinery, section 11.11), and how the speed is then, with what turns already.
std::variant<FlywheelFigures, CycleProblem> find_flywheel(CycleSampler& sampler,
                                                          const FlywheelPlan& plan);

}  // namespace kinestat
