// Marks of points that differ in shape.
#pragma once

#include "draw/svg.hpp"

namespace kinestat {

/// How many shapes there are; then they begin again.
inline constexpr int kMarkerShapes = 8;

/// The n-th shape at a place: disc, square, triangle, diamond, then the same hollow.
void draw_marker(int shape, PixelPoint place, Ink ink, double size, Svg& svg);

}  // namespace kinestat
