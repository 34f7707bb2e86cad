// Teeth for the stationary ratio of a planetary set.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "studies/transmissions/roles.hpp"

namespace kinestat {

/// Numbers of teeth, and how many planets stand round the sun, or pairs of them, which are equal.
struct SetTeeth {
  int sun = 0;
  int planet = 0;
  int ring = 0;
  int planets = 0;

  double stationary_ratio() const { return static_cast<double>(ring) / sun; }
};

/// What stands where nothing is asked.
inline constexpr int kUsualLeastPlanet = 15;
inline constexpr std::array kUsualPlanetCounts = {3, 4, 5};

/// What teeth sets may have.
struct TeethLimits {
  int least_sun = 0;
  int largest_sun = 0;
  int least_ring = 0;
  int largest_ring = 0;
  int least_planet = 0;
  std::vector<int> planets;  ///< how many stand round the sun, or pairs of them
};

/// The set with the smallest ring without profile shift of which the planets can be assembled and
/// do not touch, that has the ratio; within limits only ratios of `ratios_of_teeth` have one.
/// Without limits it is the smallest that has the ratio nearly where only large ones have it, and
/// the nearest, with planets of any size, where it is close to 1.
SetTeeth choose_teeth(SetKind kind,
                      double stationary_ratio,
                      const std::optional<TeethLimits>& limits);

/// The stationary ratios that sets within the limits have, ascending.
std::vector<double> ratios_of_teeth(SetKind kind, const TeethLimits& limits);

/// Teeth of the sun by those of a planet: how much faster than the sun it turns in its carrier.
double sun_by_planet(SetKind kind,
                     double stationary_ratio,
                     const std::optional<TeethLimits>& limits);

}  // namespace kinestat
