#include "studies/transmissions/teeth_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/synthesis_tolerance.hpp"

namespace kinestat {

namespace {

// Rings up to that many teeth are looked at for the ratio itself, larger ones for one near it.
constexpr int kLargestExactRing = 200;
constexpr int kLargestRing = 1000;

// Where nothing is asked of teeth.
TeethLimits usual_limits(int largest_ring) {
  return {.least_sun = 18,
          .largest_sun = largest_ring,
          .least_ring = 19,
          .largest_ring = largest_ring,
          .least_planet = kUsualLeastPlanet,
          .planets = {kUsualPlanetCounts.begin(), kUsualPlanetCounts.end()}};
}

// Tips stand a module outside of the pitch circle: two teeth of the diameter.
constexpr double kTips = 2.0;

// By the law of cosines; lengths are in teeth, as diameters are.
double opposite_side(double a, double b, double angle) {
  return std::sqrt(a * a + b * b - 2.0 * a * b * std::cos(angle));
}

std::optional<SetTeeth> simple_set(int sun, int ring, int count, int least_planet) {
  const int planet = (ring - sun) / 2;
  const bool is_closed = sun + 2 * planet == ring;
  const double apart = (sun + planet) * std::sin(std::numbers::pi / count);
  return is_closed && planet >= least_planet && (sun + ring) % count == 0 && apart > planet + kTips
             ? std::optional(SetTeeth{.sun = sun, .planet = planet, .ring = ring, .planets = count})
             : std::nullopt;
}

// Pairs of equal planets: the inner one stands on the sun, the outer one in the ring.
bool fits_pairs(const SetTeeth& set) {
  const double planet = set.planet;
  const double inner = set.sun + planet;
  const double outer = set.ring - planet;
  const double between = 2.0 * planet;
  // Beside each other, and neither the outer one on the sun nor the inner one in the ring.
  if (std::abs(outer - inner) >= between || outer - planet <= set.sun + 2.0 * kTips ||
      inner + planet + 2.0 * kTips >= set.ring) {
    return false;
  }
  const double turn = 2.0 * std::numbers::pi / set.planets;
  const double ahead =
      std::acos((inner * inner + outer * outer - between * between) / (2.0 * inner * outer));
  const double touch = between + 2.0 * kTips;
  return ahead < turn && opposite_side(inner, inner, turn) > touch &&
         opposite_side(outer, outer, turn) > touch &&
         opposite_side(inner, outer, turn - ahead) > touch;
}

std::optional<SetTeeth> double_planet_set(int sun, int ring, int count, int least_planet) {
  if ((ring - sun) % count != 0) {
    return std::nullopt;
  }
  // With the least planets both axes and the centre are in one line.
  for (int planet = std::max(least_planet, (ring - sun) / 4 + 1); 2 * planet < ring - sun;
       ++planet) {
    const SetTeeth set{.sun = sun, .planet = planet, .ring = ring, .planets = count};
    if (fits_pairs(set)) {
      return set;
    }
  }
  return std::nullopt;
}

std::optional<SetTeeth> set_of(SetKind kind, int sun, int ring, int count, int least_planet) {
  return kind == SetKind::simple ? simple_set(sun, ring, count, least_planet)
                                 : double_planet_set(sun, ring, count, least_planet);
}

// The first of the numbers of planets that can be assembled.
std::optional<SetTeeth> set_within(SetKind kind, int sun, int ring, const TeethLimits& limits) {
  for (const int count : limits.planets) {
    if (const auto set = set_of(kind, sun, ring, count, limits.least_planet)) {
      return set;
    }
  }
  return std::nullopt;
}

std::optional<SetTeeth> find_set(SetKind kind,
                                 double ratio,
                                 double error,
                                 const TeethLimits& limits) {
  for (int ring = limits.least_ring; ring <= limits.largest_ring; ++ring) {
    const int sun = static_cast<int>(std::lround(ring / ratio));
    if (sun >= limits.least_sun && sun <= limits.largest_sun &&
        std::abs(static_cast<double>(ring) / sun - ratio) <= error) {
      if (const auto set = set_within(kind, sun, ring, limits)) {
        return set;
      }
    }
  }
  return std::nullopt;
}

// Planets of any size.
SetTeeth nearest_set(SetKind kind, double ratio) {
  TeethLimits limits = usual_limits(kLargestRing);
  limits.least_planet = 1;
  SetTeeth nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int sun = limits.least_sun; sun < kLargestRing; ++sun) {
    const int middle = static_cast<int>(std::lround(sun * ratio));
    for (int ring = std::max(sun + 2, middle - 3); ring <= middle + 9; ++ring) {
      const auto set = set_within(kind, sun, ring, limits);
      const double error = std::abs(static_cast<double>(ring) / sun - ratio);
      if (set && error < least) {
        least = error;
        nearest = *set;
      }
    }
  }
  return nearest;
}

}  // namespace

SetTeeth choose_teeth(SetKind kind,
                      double stationary_ratio,
                      const std::optional<TeethLimits>& limits) {
  if (limits) {
    return find_set(kind, stationary_ratio, kRangeSlack, *limits).value_or(SetTeeth{});
  }
  for (const auto& [error, largest] :
       {std::pair(kRangeSlack, kLargestExactRing), std::pair(kNearStationaryRatio, kLargestRing)}) {
    if (const auto set = find_set(kind, stationary_ratio, error, usual_limits(largest))) {
      return *set;
    }
  }
  return nearest_set(kind, stationary_ratio);
}

std::vector<double> ratios_of_teeth(SetKind kind, const TeethLimits& limits) {
  std::vector<double> ratios;
  for (int sun = limits.least_sun; sun <= limits.largest_sun; ++sun) {
    for (int ring = std::max(sun + 1, limits.least_ring); ring <= limits.largest_ring; ++ring) {
      if (set_within(kind, sun, ring, limits)) {
        ratios.push_back(static_cast<double>(ring) / sun);
      }
    }
  }
  std::ranges::sort(ratios);
  ratios.erase(std::unique(ratios.begin(), ratios.end()), ratios.end());
  return ratios;
}

double sun_by_planet(SetKind kind,
                     double stationary_ratio,
                     const std::optional<TeethLimits>& limits) {
  if (kind == SetKind::simple) {
    return 2.0 / (stationary_ratio - 1.0);  // sun + 2 planets = ring
  }
  const SetTeeth teeth = choose_teeth(kind, stationary_ratio, limits);
  return static_cast<double>(teeth.sun) / teeth.planet;
}

}  // namespace kinestat
