// The symbols of springs, dampers and gas springs.
#pragma once

#include "draw/symbols.hpp"
#include "mechanism/springs/spring.hpp"

namespace kinestat {

inline constexpr double kSpringHalf = 7.0;     ///< half the width of a coil or cylinder [px]
inline constexpr double kSpiralRadius = 15.0;  ///< [px]

/// Where a spring is on a picture.
struct SpringPlace {
  PixelPoint from;
  PixelPoint to;
  double drawn = 0.0;  ///< its length as drawn [px]
  double scale = 1.0;  ///< of the picture [px/m]
};

/// A coil, with as many turns however it is stretched; of a gas spring the cylinder, as long as its
/// rod can be pushed in, and the rod; of what only damps a dashpot.
void draw_spring(Svg& svg, const Spring& spring, const SpringPlace& place);

/// Around a hinge.
void draw_spiral(Svg& svg, PixelPoint at);

}  // namespace kinestat
