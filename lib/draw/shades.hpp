// Shades of one ink, for areas that stand for classes of a value.
#pragma once

#include "core/contract.hpp"

namespace kinestat {

/// How opaque an area of `Ink::blue` is that stands for the step-th of so many classes, from 0.
/// Lightness alone tells them apart, in even steps from paper.
constexpr double shade_opacity(int step, int steps) {
  KINESTAT_EXPECTS(0 <= step && step < steps);
  constexpr double kLeast = 0.1;
  return steps == 1 ? 1.0 : kLeast + (1.0 - kLeast) * step / (steps - 1);
}

}  // namespace kinestat
