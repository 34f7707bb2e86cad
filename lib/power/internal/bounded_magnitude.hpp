// Rates and actions with bounds of their errors.
#pragma once

#include <cmath>

#include "core/accuracy.hpp"
#include "core/rounding.hpp"
#include "kinematics/bounded_motion.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

inline bool has_bounds(const AnswerEvidence& answer) {
  return !answer.bounds.empty();
}

/// What was typed, too, is not the decimal number but the one next to it; of several that cancel,
/// that may be all there is.
inline BoundedNumber rounded_as_typed(const BoundedNumber& number) {
  return {.value = number.value, .bound = number.bound + kDataRounding * std::abs(number.value)};
}

}  // namespace kinestat
