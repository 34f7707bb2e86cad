// What actuators have to do in a whole motion, and where its energy goes.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "mechanism/dynamics_plan.hpp"
#include "studies/motion/report/motion_dynamics.hpp"
#include "studies/motion/task/cycle/cycle_checks.hpp"

namespace kinestat {

struct WatchedMotion {
  std::vector<ActuatorFigures> actuators;
  EnergyFigures energy;
};

/// Of any motion in time with inertia, be it a cycle or not. Kinetic energy follows from the
/// velocities alone, and powers from actions: that they agree is no matter of course.
std::variant<WatchedMotion, CycleProblem> find_actuators(CycleSampler& sampler,
                                                         std::span<const WatchedActuator> plan);

}  // namespace kinestat
