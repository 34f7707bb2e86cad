// What tolerances of parts and drives add up to at a watched position.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/tolerance/influences.hpp"

namespace kinestat {

/// How far parts at a coupling may stand from where they are drawn, and drives from where they are
/// held: each by no more than that, in any direction. Lists are parallel to the couplings and to
/// the known motions of the case.
struct PartTolerances {
  std::vector<double> places;  ///< [m]
  std::vector<double> angles;  ///< [rad]
  std::vector<double> drives;  ///< [rad or m]
};

/// What one place, angle or drive does to a watched position.
struct ToleranceShare {
  std::string name;                          ///< "C/place", "G/angle", "motor/drive"
  QuantityKind kind = QuantityKind::length;  ///< of the deviation: a length or an angle
  double influence = 0.0;                    ///< of a unit in the direction that counts most [SI]
  std::optional<Vec3> direction;  ///< that one, unit vector; none of a drive, or without influence
  double tolerance = 0.0;         ///< [m or rad]
  double moved = 0.0;             ///< size of influence times tolerance
};

struct ToleranceStack {
  WatchedPosition position;
  std::vector<ToleranceShare> shares = {};  ///< the couplings in order, then the drives
  double worst_case = 0.0;                  ///< sum of what all move
  double root_sum_square = 0.0;  ///< of the same: all deviations by chance, none like another
};

/// Of each watched position that the drives hold. Deviations of the same coupling are brought
/// together: places, and angles. `influences` are those of the case.
std::vector<ToleranceStack> stack_tolerances(const Mechanism& mechanism,
                                             const Case& which,
                                             std::span<const Deviation> deviations,
                                             std::span<const WatchedPosition> watched,
                                             const Influences& influences,
                                             const PartTolerances& tolerances);

}  // namespace kinestat
