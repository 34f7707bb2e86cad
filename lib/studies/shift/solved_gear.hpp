// A gear with the answer of its case.
#pragma once

#include <optional>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/shift_plan.hpp"
#include "statics/static_solution.hpp"
#include "studies/shift/shift_state.hpp"

namespace kinestat {

struct SolvedGear {
  const Mechanism& mechanism;
  const ShiftPlan& plan;
  const ShiftState& state;
  const Case& which;
  const KinematicSolution* motion = nullptr;  ///< null where the case has none
  const StaticSolution* action = nullptr;     ///< likewise, without losses of meshes
  const std::vector<std::optional<double>>* lossy_actions = nullptr;  ///< with them; null: none
};

/// Speed of an element, head minus tail [rad/s]; empty where the gear leaves it open. Where its
/// case has no velocities, as friction of what turns freely beside it is not known, the state has
/// them.
std::optional<double> slip_of(const SolvedGear& gear, std::size_t element);

/// Action of an element, tail on head [N·m], without and with losses of meshes.
std::optional<double> torque_of(const SolvedGear& gear, std::size_t element);
std::optional<double> lossy_torque_of(const SolvedGear& gear, std::size_t element);

}  // namespace kinestat
