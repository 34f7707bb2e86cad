// What a gear gives beside the solution of its case.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "power/ratio.hpp"
#include "studies/shift/shift_solution.hpp"

namespace kinestat {

/// A gear and what its case gave.
struct SolvedGear {
  const Mechanism& mechanism;
  const ShiftPlan& plan;
  const NamedShiftState& state;
  const Case& which;
  const KinematicSolution* motion = nullptr;  ///< null where the case has none
  const StaticSolution* action = nullptr;     ///< likewise, without losses of meshes
  const std::vector<std::optional<double>>* lossy_actions = nullptr;  ///< with them; null: none
};

/// A coupling and the force that it bears [N].
struct LoadedCoupling {
  std::string name;
  double force = 0.0;
};

/// In SI, in the order of the plan. Empty what the case does not determine.
struct GearValues {
  std::vector<Ratios> ratios;                        ///< to each output
  std::vector<std::optional<double>> torques;        ///< of each element, tail on head [N m]
  std::vector<std::optional<double>> lossy_torques;  ///< likewise with losses of meshes
  std::vector<std::optional<double>> slips;          ///< of each element, head minus tail [rad/s]
  std::optional<LoadedCoupling> bearing;             ///< the one with the largest force
  std::optional<LoadedCoupling> mesh;                ///< likewise
};

GearValues find_gear_values(const SolvedGear& gear);

}  // namespace kinestat
