// What a gear gives beside the solution of its case.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "power/ratio.hpp"
#include "studies/shift/gear_limits.hpp"
#include "studies/shift/solved_gear.hpp"

namespace kinestat {

/// A coupling and the force that it bears [N].
struct LoadedCoupling {
  std::string name;  ///< empty where none bears any
  double force = 0.0;
};

/// In SI, in the order of the plan. Empty what the case does not determine.
struct GearValues {
  std::vector<Ratios> ratios;                        ///< to each output
  std::vector<std::optional<double>> torques;        ///< of each element, tail on head [N m]
  std::vector<std::optional<double>> lossy_torques;  ///< likewise with losses of meshes
  std::vector<std::optional<double>> slips;          ///< of each element, head minus tail [rad/s]
  std::optional<LoadedCoupling> bearing;             ///< the one with the largest force; empty
                                                     ///< without any, or where that of one is open
  std::optional<LoadedCoupling> mesh;                ///< likewise
  std::vector<LimitUse> limits;                      ///< what it takes of those of the plan
};

GearValues find_gear_values(const SolvedGear& gear);

}  // namespace kinestat
