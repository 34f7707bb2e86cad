// What of a dyad its numbers tell: with what its positions leave open, and what doubles round.
#pragma once

#include "studies/synthesis/dyads/dyad.hpp"

namespace kinestat {

/// As rounded as coordinates of its size, and within `bound` besides.
inline BoundedPoint rounded_point(const Point& value, const Point& bound) {
  return BoundedPoint::within(value, bound + BoundedPoint::written(value).bound());
}

inline BoundedPoint circle_point_of(const Dyad& dyad) {
  return rounded_point(dyad.circle_point, dyad.circle_bound);
}

inline BoundedPoint centre_point_of(const Dyad& dyad) {
  return rounded_point(dyad.centre_point, dyad.centre_bound);
}

inline BoundedPoint direction_of(const Dyad& dyad) {
  return rounded_point(dyad.direction, dyad.direction_bound);
}

inline BoundedNumber distance(const BoundedPoint& a, const BoundedPoint& b) {
  const BoundedPoint between = b - a;
  return {.value = std::abs(between.value()), .bound = std::abs(between.bound())};
}

/// It is the distance of its centre from a place that is the origin of the plane and an arm in it,
/// all of which round by their own distance from the origins.
inline BoundedNumber length_of(const Dyad& crank) {
  const double far = std::abs(crank.centre_point) + std::abs(crank.circle_point) + crank.length;
  return {.value = crank.length,
          .bound = std::abs(centre_point_of(crank).bound()) +
                   std::abs(circle_point_of(crank).bound()) + kDataRounding * far};
}

}  // namespace kinestat
