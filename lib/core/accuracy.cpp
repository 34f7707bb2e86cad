#include "core/accuracy.hpp"

#include <cmath>

namespace kinestat {

bool reaches(const AnswerEvidence& evidence, int digits) {
  return evidence.error_bound && *evidence.error_bound <= std::pow(10.0, -digits);
}

}  // namespace kinestat
