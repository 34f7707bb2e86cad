// A motion of a file, with what it was made of.
#pragma once

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
};

}  // namespace kinestat
