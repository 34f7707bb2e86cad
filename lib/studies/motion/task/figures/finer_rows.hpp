// Positions between the rows of a motion whose steps are few, for its events and figures.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// The same motion with every step divided into equal parts, without its table.
struct FinerMotion {
  FoundMotion motion;
  std::vector<std::size_t> rows;  ///< in it, of the rows of the motion that was divided
};

/// How many parts of each step events and figures need: with few steps, several reversals may lie
/// within one, and nothing is seen of what rises and falls again.
int parts_of_step(const Mechanism& mechanism, const MotionPlan& plan, int steps);

/// Into the parts that they need. Empty where the steps are fine enough, or the motion cannot be
/// followed to their parts.
std::optional<FinerMotion> divide_steps(const Mechanism& mechanism, const FoundMotion& motion);

/// Leaves only the rows of the motion that was divided in its table; places between the finer rows
/// become places between these.
void keep_rows(const FinerMotion& finer, int steps, MotionTable& table);

}  // namespace kinestat
