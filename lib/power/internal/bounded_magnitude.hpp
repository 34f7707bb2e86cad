// Whether rates or actions have bounds of their errors.
#pragma once

#include "core/accuracy.hpp"
#include "kinematics/bounded_motion.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

inline bool has_bounds(const AnswerEvidence& answer) {
  return !answer.bounds.empty();
}

}  // namespace kinestat
