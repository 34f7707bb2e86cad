// The fit of equal planets around their sun: whether they can be assembled, and their clearance.
#pragma once

#include <string>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// Several equal planets, or sets of planets that mesh with each other.
struct PlanetFit {
  std::string planet;  ///< the member with the count
  int count = 0;
  bool assembles = false;  ///< whether they can be placed at equal angles; W0306 if not
  double clearance = 0.0;  ///< least distance of the tips of neighbours [m]; negative if they
                           ///< overlap (W0307)
};

/// Finds the fits in the order of the file; none for a single planet, or if `gears` is wrong.
std::vector<PlanetFit> find_planet_fits(const MechanismDescription& description);

}  // namespace kinestat
