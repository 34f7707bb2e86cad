// A motion of a file, with what it was made of.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/motion_plan.hpp"
#include "studies/motion/motion_solution.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// A motion that was found, as far as it goes.
struct FoundMotion {
  MotionPlan plan;
  MotionNetwork network;
  std::vector<DrawnCoupling> drawn;
  MotionSolution solution;
  MotionTable table;
  std::optional<Mechanism> near;  ///< of a mechanism far from the origin of the world: beside it,
                                  ///< as it was moved; network, couplings and plan are of this one
  Vec3 origin = Vec3::Zero();     ///< where its origin is in the world [m]
};

}  // namespace kinestat
