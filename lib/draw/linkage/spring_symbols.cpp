#include "draw/linkage/spring_symbols.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace kinestat {

namespace {

const Paint kWire = {.stroke = Ink::ink, .width = 1.4, .round_ends = true};
const Paint kBody = {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.4};

// Along a spring and across it [px].
struct SpringAxes {
  PixelPoint from;
  PixelPoint along;
  PixelPoint across;

  PixelPoint at(double x, double y) const { return from + x * along + y * across; }
};

void draw_coil(Svg& svg, const SpringAxes& axes, double length, double drawn) {
  constexpr double kPitch = 8.0;  // as drawn [px]
  const int crossings = 2 * static_cast<int>(std::clamp(drawn / (2 * kPitch), 4.0, 20.0));
  const double lead = std::min(12.0, 0.15 * length);
  const double pitch = (length - 2 * lead) / crossings;
  std::vector<PixelPoint> wire = {axes.from, axes.at(lead, 0.0)};
  for (int i = 0; i < crossings; ++i) {
    wire.push_back(axes.at(lead + (i + 0.5) * pitch, i % 2 == 0 ? kSpringHalf : -kSpringHalf));
  }
  wire.push_back(axes.at(length - lead, 0.0));
  wire.push_back(axes.at(length, 0.0));
  svg.polyline(wire, kWire);
}

void draw_cylinder(Svg& svg, const SpringAxes& axes, double length, double cylinder) {
  svg.line(axes.at(cylinder, 0.0), axes.at(length, 0.0), {.stroke = Ink::ink, .width = 2.6});
  const std::array<PixelPoint, 4> corners = {axes.at(0.0, -kSpringHalf),
                                             axes.at(cylinder, -kSpringHalf),
                                             axes.at(cylinder, kSpringHalf),
                                             axes.at(0.0, kSpringHalf)};
  svg.polygon(corners, kBody);
}

void draw_dashpot(Svg& svg, const SpringAxes& axes, double length) {
  const double begin = 0.3 * length;
  const double end = 0.7 * length;
  svg.line(axes.from, axes.at(begin, 0.0), kWire);
  const std::array<PixelPoint, 4> cup = {axes.at(end, -kSpringHalf),
                                         axes.at(begin, -kSpringHalf),
                                         axes.at(begin, kSpringHalf),
                                         axes.at(end, kSpringHalf)};
  svg.polyline(cup, kWire);
  const double piston = 0.5 * length;
  const double half = 0.7 * kSpringHalf;
  svg.line(axes.at(piston, -half), axes.at(piston, half), {.stroke = Ink::ink, .width = 2.6});
  svg.line(axes.at(piston, 0.0), axes.at(length, 0.0), kWire);
}

}  // namespace

void draw_spring(Svg& svg, const Spring& spring, const SpringPlace& place) {
  const double length = length_of(place.to - place.from);
  const PixelPoint along = unit_of(place.to - place.from);
  const SpringAxes axes = {.from = place.from, .along = along, .across = left_of(along)};
  if (spring.gas) {
    const double cylinder = place.scale * (spring.gas->length - spring.gas->stroke);
    draw_cylinder(svg, axes, length, std::clamp(cylinder, 0.2 * length, 0.95 * length));
  } else if (spring.stiffness == 0.0 && spring.damping != 0.0) {
    draw_dashpot(svg, axes, length);
  } else {
    draw_coil(svg, axes, length, place.drawn);
  }
}

void draw_spiral(Svg& svg, PixelPoint at) {
  constexpr double kInner = 6.0;  // [px]
  constexpr int kPoints = 60;
  constexpr double kTurns = 2.25;
  std::vector<PixelPoint> wire;
  for (int i = 0; i <= kPoints; ++i) {
    const double share = static_cast<double>(i) / kPoints;
    const double angle = 2 * std::numbers::pi * kTurns * share;
    const double radius = kInner + (kSpiralRadius - kInner) * share;
    wire.push_back(at + radius * PixelPoint{.x = std::cos(angle), .y = -std::sin(angle)});
  }
  svg.polyline(wire, kWire);
}

}  // namespace kinestat
