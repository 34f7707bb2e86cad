// Four-bars of the reference tasks, and how they move through their positions.
#pragma once

#include <string>
#include <vector>

#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

struct ReferenceDrive {
  std::vector<double> angles;        ///< of the crank from the line of centres [deg]
  std::vector<double> transmission;  ///< [deg]
  bool same_circuit = false;
  bool same_branch = false;
  std::vector<double> working_arc;  ///< least and largest transmission angle [deg], if any
  bool turns_fully = false;
};

/// Computed in arithmetic of 60 digits, independently of this library; the working arc by a scan.
struct ReferenceFourBar {
  std::string task;     ///< a name of reference_tasks()
  std::size_t one = 0;  ///< which of its dyads
  std::size_t other = 0;
  FourBarLengths lengths;
  std::string grashof;
  std::vector<ReferenceDrive> drives;
  Point third_pivot;  ///< of the cognates that trace the origin of the moving frame
};

/// Those of do Valle's tables, with case 1.
const std::vector<ReferenceFourBar>& four_bars_of_the_source();

/// All of them.
std::vector<ReferenceFourBar> reference_four_bars();

}  // namespace kinestat
