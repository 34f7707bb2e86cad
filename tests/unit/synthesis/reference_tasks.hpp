// Tasks whose dyads are known to 60 digits, for the very doubles that are given here.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "studies/synthesis/dyads/dyad.hpp"

namespace kinestat {

/// The dyads were computed in arithmetic of 60 digits by the elimination of the circle and centre
/// coordinates, independently of this library. Names IC…: positions of a four-bar or slider-crank
/// that is known; tables: do Valle 1983, with the inflection circle in the fixed frame where the
/// source mixes frames ("literal": as it is printed).
struct ReferenceTask {
  std::string name;
  std::vector<PositionJets> positions;
  std::vector<Dyad> dyads;  ///< kind, circle point in the moving frame, centre in the fixed one
  int imaginary_count = 0;
  double tolerance = 0.0;  ///< relative, by what rounding of the positions leaves
};

const std::vector<ReferenceTask>& reference_tasks();

inline const ReferenceTask& reference_task(const std::string& name) {
  return *std::ranges::find(reference_tasks(), name, &ReferenceTask::name);
}

}  // namespace kinestat
