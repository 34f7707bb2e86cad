// How near dyads are to expected ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "studies/synthesis/dyads/dyad.hpp"

namespace kinestat {

inline double relative(const Point& found, const Point& expected) {
  return std::abs(found - expected) / std::max(std::abs(expected), 1.0);
}

/// Relative distance of their points and directions; huge for different kinds.
inline double distance(const Dyad& found, const Dyad& expected) {
  if (found.kind != expected.kind) {
    return 1e300;
  }
  const double circle = relative(found.circle_point, expected.circle_point);
  const double turned = std::abs(cross(found.direction, expected.direction));
  switch (found.kind) {
    case DyadKind::crank:
      return std::max(circle, relative(found.centre_point, expected.centre_point));
    case DyadKind::slider:
      return std::max(circle, turned);
    case DyadKind::inverted_slider:
      return std::max({circle, turned, relative(found.centre_point, expected.centre_point)});
  }
  return 1e300;
}

/// The one of the dyads that is nearest to the expected one, or a default one.
inline Dyad nearest_dyad(const std::vector<Dyad>& found, const Dyad& expected) {
  const auto nearest = std::ranges::min_element(found, [&](const Dyad& a, const Dyad& b) {
    return distance(a, expected) < distance(b, expected);
  });
  return nearest == found.end() ? Dyad{} : *nearest;
}

inline double nearest(const std::vector<Dyad>& found, const Dyad& expected) {
  return found.empty() ? 1e300 : distance(nearest_dyad(found, expected), expected);
}

}  // namespace kinestat
