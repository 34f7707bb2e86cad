// Rates and actions with the bounds of their errors.
#pragma once

#include <cstddef>
#include <vector>

#include "core/accuracy.hpp"
#include "kinematics/kinematic_solution.hpp"
#include "math/bounded_number.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

inline bool has_bounds(const AnswerEvidence& answer) {
  return !answer.bounds.empty();
}

/// Of a freedom [rad/s or m/s]; the rates must have bounds.
inline BoundedNumber bounded_rate(const KinematicSolution& motion, int freedom) {
  const auto f = static_cast<std::size_t>(freedom);
  return {.value = motion.rates[f], .bound = motion.answer.bounds[f]};
}

/// Of an action that is known [N·m or N]; the actions must have bounds.
inline BoundedNumber bounded_action(const StaticSolution& solution, int action) {
  const auto a = static_cast<std::size_t>(action);
  return {.value = *solution.magnitudes[a], .bound = solution.answer.bounds[a]};
}

}  // namespace kinestat
