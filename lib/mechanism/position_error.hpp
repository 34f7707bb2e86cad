// How far off the bodies of a moved mechanism may be.
#pragma once

#include <algorithm>

#include "core/motion_tolerance.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// As share of the size, 0 as drawn. What a closure by least squares misses beyond rounding belongs
/// to the drawing and is no error of the position.
inline double position_error(const Mechanism& mechanism) {
  return std::min(mechanism.closure_error, kLeastCorrection);
}

}  // namespace kinestat
