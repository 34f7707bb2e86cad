// The symbols of drawings: supports, guides, blocks, rounded links, turning arrows.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "draw/svg.hpp"

namespace kinestat {

inline PixelPoint operator+(PixelPoint a, PixelPoint b) {
  return {.x = a.x + b.x, .y = a.y + b.y};
}

inline PixelPoint operator-(PixelPoint a, PixelPoint b) {
  return {.x = a.x - b.x, .y = a.y - b.y};
}

inline PixelPoint operator*(double factor, PixelPoint a) {
  return {.x = factor * a.x, .y = factor * a.y};
}

/// Without the care that std::hypot takes, in a tenth of its time: pixels are far from overflow.
inline double length_of(PixelPoint a) {
  return std::sqrt(a.x * a.x + a.y * a.y);
}

/// Of length 1; x for a zero vector.
PixelPoint unit_of(PixelPoint a);

/// Turned anticlockwise as seen on the picture.
inline PixelPoint left_of(PixelPoint a) {
  return {.x = a.y, .y = -a.x};
}

/// The corners of the convex hull, anticlockwise as computed with y upwards; points within a line
/// are left out.
std::vector<PixelPoint> convex_hull(std::vector<PixelPoint> points);

/// A circle.
struct Round {
  PixelPoint centre;
  double radius = 0.0;
};

/// The hull of circles: of two equal ones a bar with round ends.
std::vector<PixelPoint> rounded_hull(std::span<const Round> rounds);

/// Part of a circle as points, by angles in radians anticlockwise from x on the picture.
std::vector<PixelPoint> arc_points(PixelPoint centre, double radius, double from, double to);

/// Part of the circle around `centre` from a point to another, in a sense on the picture.
std::vector<PixelPoint> arc_between(PixelPoint centre,
                                    PixelPoint from,
                                    PixelPoint to,
                                    bool is_anticlockwise);

/// A line with strokes on its right as one walks from `from` to `to`: what is fixed.
void draw_fixed_line(Svg& svg, PixelPoint from, PixelPoint to);

/// The support of a pin that turns in the ground, below it.
void draw_support(Svg& svg, PixelPoint pin);

/// A pin on which something turns.
void draw_pin(Svg& svg, PixelPoint at, double radius = 4.0);

/// The block of a slider, along a unit vector.
void draw_block(Svg& svg, PixelPoint at, PixelPoint along, const Paint& paint);

/// An arrow around a point, anticlockwise or clockwise on the picture.
void draw_turning_arrow(
    Svg& svg, PixelPoint centre, double radius, bool is_anticlockwise, const Paint& paint);

/// Strokes along a pitch circle; not as many as there are teeth.
void draw_teeth(Svg& svg, PixelPoint centre, double radius, Ink ink);

/// A rolling contact at a point: the head's roller, `out` from it, and the tangent.
void draw_contact(Svg& svg, PixelPoint at, PixelPoint out);

inline constexpr double kRackDepth = 14.0;  ///< [px]

/// A bar with strokes for its teeth, whose back lies `away` from the pitch point.
void draw_rack_bar(Svg& svg, PixelPoint at, PixelPoint away, Ink ink);

/// The box around a circle.
PixelBox box_of_circle(PixelPoint centre, double radius);

/// 1, 2 or 5 times a power of ten, the largest that is at most `value`.
double round_length(double value);

/// Four significant digits at most: "0.1852", "1500".
std::string short_number(double value);

}  // namespace kinestat
