#include "draw/symbols.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/axes.hpp"

namespace kinestat {

namespace {

constexpr double kSupportHeight = 16.0;
constexpr double kSupportHalf = 11.0;
constexpr double kBlockHalfLength = 15.0;
constexpr double kBlockHalfWidth = 9.0;

double turn(PixelPoint a, PixelPoint b, PixelPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// One side of the hull of points that are sorted.
template <class Iterator>
std::vector<PixelPoint> chain(Iterator from, Iterator to) {
  std::vector<PixelPoint> side;
  for (; from != to; ++from) {
    while (side.size() > 1 && turn(side[side.size() - 2], side.back(), *from) <= 0.0) {
      side.pop_back();
    }
    side.push_back(*from);
  }
  return side;
}

}  // namespace

PixelPoint unit_of(PixelPoint a) {
  const double length = length_of(a);
  return length > 0.0 ? (1.0 / length) * a : PixelPoint{.x = 1.0, .y = 0.0};
}

std::vector<PixelPoint> convex_hull(std::vector<PixelPoint> points) {
  std::ranges::sort(
      points, [](PixelPoint a, PixelPoint b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<PixelPoint> hull = chain(points.begin(), points.end());
  const std::vector<PixelPoint> back = chain(points.rbegin(), points.rend());
  if (hull.size() > 1) {
    hull.insert(hull.end(), back.begin() + 1, back.end() - 1);
  }
  return hull;
}

std::vector<PixelPoint> rounded_hull(std::span<const Round> rounds) {
  std::vector<PixelPoint> points;
  for (const Round& round : rounds) {
    const int sides = std::max(24, static_cast<int>(round.radius));
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      points.push_back(round.centre +
                       round.radius * PixelPoint{.x = std::cos(angle), .y = std::sin(angle)});
    }
  }
  return convex_hull(std::move(points));
}

std::vector<PixelPoint> arc_points(PixelPoint centre, double radius, double from, double to) {
  constexpr double kStepOfArc = std::numbers::pi / 36;
  const int count = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) / kStepOfArc)));
  std::vector<PixelPoint> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.push_back(centre + radius * PixelPoint{.x = std::cos(angle), .y = -std::sin(angle)});
  }
  return points;
}

std::vector<PixelPoint> arc_between(PixelPoint centre,
                                    PixelPoint from,
                                    PixelPoint to,
                                    bool is_anticlockwise) {
  const PixelPoint begin = from - centre;
  const PixelPoint end = to - centre;
  const double begin_angle = std::atan2(-begin.y, begin.x);
  double end_angle = std::atan2(-end.y, end.x);
  if (is_anticlockwise && end_angle < begin_angle) {
    end_angle += 2 * std::numbers::pi;
  } else if (!is_anticlockwise && end_angle > begin_angle) {
    end_angle -= 2 * std::numbers::pi;
  }
  return arc_points(centre, length_of(begin), begin_angle, end_angle);
}

void draw_fixed_line(Svg& svg, PixelPoint from, PixelPoint to) {
  constexpr double kDistance = 6.0;
  constexpr double kLength = 7.0;
  const PixelPoint along = unit_of(to - from);
  const PixelPoint right = -1.0 * left_of(along);
  const int count = static_cast<int>(length_of(to - from) / kDistance);
  std::vector<PixelLine> hatching;
  for (int i = 1; i <= count; ++i) {
    const PixelPoint begin = from + (i * kDistance) * along;
    hatching.push_back({.from = begin, .to = begin + kLength * unit_of(right - along)});
  }
  svg.strokes(hatching, {.stroke = Ink::soft, .width = 1.0});
  svg.line(from, to, {.stroke = Ink::ink, .width = 1.6});
}

void draw_support(Svg& svg, PixelPoint pin) {
  const PixelPoint left = pin + PixelPoint{.x = -kSupportHalf, .y = kSupportHeight};
  const PixelPoint right = pin + PixelPoint{.x = kSupportHalf, .y = kSupportHeight};
  const std::vector<PixelPoint> corners = {pin, right, left};
  svg.polygon(corners, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.4});
  const PixelPoint more = {.x = 5.0, .y = 0.0};
  draw_fixed_line(svg, left - more, right + more);
}

void draw_pin(Svg& svg, PixelPoint at, double radius) {
  svg.circle(at, radius, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.6});
}

void draw_block(Svg& svg, PixelPoint at, PixelPoint along, const Paint& paint) {
  const PixelPoint across = left_of(along);
  std::vector<PixelPoint> corners;
  for (const auto& [a, b] :
       {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)}) {
    corners.push_back(at + (a * kBlockHalfLength) * along + (b * kBlockHalfWidth) * across);
  }
  svg.polygon(corners, {.stroke = Ink::none, .fill = Ink::paper});
  svg.polygon(corners, paint);
}

void draw_turning_arrow(
    Svg& svg, PixelPoint centre, double radius, bool is_anticlockwise, const Paint& paint) {
  constexpr double kHead = 8.0;
  const double sense = is_anticlockwise ? 1.0 : -1.0;
  const double middle = std::numbers::pi / 2;
  const double half = 0.72 * std::numbers::pi;
  const double end = middle + sense * half;
  // The arc ends where the head begins.
  const double drawn_end = end - sense * kHead / radius;
  svg.polyline(arc_points(centre, radius, middle - sense * half, drawn_end), paint);
  const PixelPoint base = arc_points(centre, radius, end, drawn_end).back();
  const PixelPoint tip = arc_points(centre, radius, drawn_end, end).back();
  svg.arrow_head(tip, tip - base, paint.stroke, kHead);
}

void draw_teeth(Svg& svg, PixelPoint centre, double radius, Ink ink) {
  constexpr double kPitch = 9.0;
  constexpr double kHalfTooth = 2.6;
  const int count = std::max(8, static_cast<int>(2 * std::numbers::pi * radius / kPitch));
  std::vector<PixelLine> teeth;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const PixelPoint out = {.x = std::cos(angle), .y = std::sin(angle)};
    teeth.push_back(
        {.from = centre + (radius - kHalfTooth) * out, .to = centre + (radius + kHalfTooth) * out});
  }
  svg.strokes(teeth, {.stroke = ink, .width = 1.0});
}

void draw_contact(Svg& svg, PixelPoint at, PixelPoint out) {
  constexpr double kRoller = 7.0;
  const PixelPoint across = 16.0 * left_of(out);
  svg.circle(at + kRoller * out, kRoller, {.stroke = Ink::ink, .fill = Ink::paper, .width = 1.5});
  svg.line(at - across, at + across, {.stroke = Ink::soft, .width = 0.9, .dash = "4 2"});
}

void draw_rack_bar(Svg& svg, PixelPoint at, PixelPoint away, Ink ink) {
  constexpr double kHalf = 110.0;
  constexpr double kPitch = 9.0;
  constexpr double kHalfTooth = 2.6;
  const PixelPoint along = left_of(away);
  const PixelPoint from = at - kHalf * along;
  const PixelPoint to = at + kHalf * along;
  const PixelPoint back = kRackDepth * away;
  const std::vector<PixelPoint> corners = {from, to, to + back, from + back};
  svg.polygon(corners, {.stroke = ink, .fill = ink, .width = 1.4, .opacity = 0.16});
  for (double s = -kHalf + kPitch / 2; s < kHalf; s += kPitch) {
    const PixelPoint tooth = at + s * along;
    svg.line(tooth - kHalfTooth * away, tooth + kHalfTooth * away, {.stroke = ink, .width = 1.0});
  }
}

PixelBox box_of_circle(PixelPoint centre, double radius) {
  PixelBox box;
  box.add(centre);
  return box.grown(radius);
}

double round_length(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= value) {
      return step * decade;
    }
  }
  return decade;
}

std::string short_number(double value) {
  return label_number(value, 4);
}

}  // namespace kinestat
