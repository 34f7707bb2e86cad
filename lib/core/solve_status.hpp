// How a solve ended: mathematics that says no is a value, not an error.
#pragma once

#include <string_view>

namespace kinestat {

enum class SolveStatus {
  solved,
  underdetermined,     ///< too few known magnitudes
  dependent,           ///< known magnitudes follow from each other
  inconsistent,        ///< known magnitudes contradict the equations
  overflow,            ///< a magnitude is above kLargestMagnitude
  locked_by_friction,  ///< friction grows without bound, or no flank of the teeth fits
  at_rest              ///< friction has no direction, because what it acts on does not move
};

/// The word in reports.
constexpr std::string_view word_of(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return "solved";
    case SolveStatus::underdetermined:
      return "indeterminate";
    case SolveStatus::dependent:
      return "dependent";
    case SolveStatus::inconsistent:
      return "inconsistent";
    case SolveStatus::overflow:
      return "overflow";
    case SolveStatus::locked_by_friction:
      return "locked";
    case SolveStatus::at_rest:
      return "at_rest";
  }
  return "";
}

}  // namespace kinestat
