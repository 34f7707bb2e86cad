// How the planets of a train stand round their sun: what is right where no warning is.
#pragma once

#include <string>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// Several equal planets, or sets of planets that mesh with each other.
struct PlanetFit {
  std::string planet;  ///< the member that has their count
  int count = 0;
  bool assembles = false;  ///< they can stand at equal angles (not W0306)
  double clearance = 0.0;  ///< least distance of the tips of neighbours [m]; negative: they overlap
                           ///< (W0307)
};

/// In the order of the file; none where a planet stands alone, or `gears` is wrong.
std::vector<PlanetFit> find_planet_fits(const MechanismDescription& description);

}  // namespace kinestat
