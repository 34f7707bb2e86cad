// What the report of one file is made of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "mobility/counts.hpp"
#include "power/power_flow.hpp"
#include "power/ratio.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The passes that a case asked for; a pass that it did not ask for is empty.
struct CaseAnalysis {
  Case which;
  std::optional<KinematicSolution> motion;
  std::optional<StaticSolution> action;
  std::optional<PowerFlow> power;
  std::optional<Ratios> ratios;
};

/// One mechanism with its counts and its cases, in file order.
struct Analysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  Mechanism mechanism;
  MobilityCounts mobility;
  std::vector<CaseAnalysis> cases;
};

}  // namespace kinestat
