// The three four-bars of Roberts and Chebyshev, whose coupler points trace one curve.
#pragma once

#include <array>
#include <optional>

#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

/// A four-bar in one of its positions [length], fixed frame.
struct FourBarPlaces {
  std::array<Point, 2> fixed;   ///< A0, B0
  std::array<Point, 2> moving;  ///< A, B
  FourBarLengths lengths;
};

/// They keep the path of the tracing point with its curvature, not the angle of its plane.
struct Cognates {
  Point third_pivot;
  std::array<FourBarPlaces, 2> linkages;  ///< on A0 and the third pivot, on B0 and the third pivot
};

/// Of a four-bar for the path of a point of its coupler [moving frame]. Empty if the linkage is
/// none, or if the point is A or B, where a cognate degenerates.
std::optional<Cognates> find_cognates(const Linkage& linkage,
                                      const Pose& pose,
                                      const Point& tracer);

}  // namespace kinestat
