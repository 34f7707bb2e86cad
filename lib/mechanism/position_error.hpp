// The error of the positions of bodies in a moved mechanism.
#pragma once

#include <algorithm>

#include "core/motion_tolerance.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The position error over the size of the mechanism; 0 as drawn. A closure error above rounding is
/// one of the drawing, which least squares cannot close, and no error of the position.
inline double position_error(const Mechanism& mechanism) {
  return std::min(mechanism.closure_error, kLeastCorrection);
}

}  // namespace kinestat
