// The lines of an Svg which labels keep off.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/svg.hpp"

namespace kinestat {

namespace {

// Whether letters upon it would be hard to read.
bool is_seen(const Paint& paint) {
  const bool is_area = paint.fill != Ink::none && paint.fill != Ink::paper &&
                       paint.fill != Ink::tint && paint.fill != Ink::grid;
  return (paint.stroke != Ink::none && paint.stroke != Ink::grid) || is_area;
}

}  // namespace

void Svg::keep(std::span<const PixelPoint> points, bool is_closed, const Paint& paint) {
  if (!keeps_lines_ || hidden_from_ > 0 || !is_seen(paint)) {
    return;
  }
  // Wide ones by both their edges.
  constexpr double kWide = 3.0;  // [px]
  const double half = paint.stroke != Ink::none && paint.width >= kWide ? paint.width / 2 : 0.0;
  const auto add = [&](PixelPoint from, PixelPoint to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (half == 0.0 || length == 0.0) {
      lines_.push_back({.from = from, .to = to});
      return;
    }
    const PixelPoint aside = {.x = half * (to.y - from.y) / length,
                              .y = half * (from.x - to.x) / length};
    for (const double side : {-1.0, 1.0}) {
      lines_.push_back({.from = {.x = from.x + side * aside.x, .y = from.y + side * aside.y},
                        .to = {.x = to.x + side * aside.x, .y = to.y + side * aside.y}});
    }
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    add(points[i - 1], points[i]);
  }
  if (is_closed && points.size() > 2) {
    add(points.back(), points.front());
  }
}

void Svg::keep_rim(PixelPoint centre, double radius, const Paint& paint) {
  if (!keeps_lines_) {
    return;
  }
  std::vector<PixelPoint> rim;
  const int sides = std::clamp(static_cast<int>(radius), 12, 96);  // within half a pixel
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    rim.push_back(
        {.x = centre.x + radius * std::cos(angle), .y = centre.y + radius * std::sin(angle)});
  }
  keep(rim, true, paint);
}

}  // namespace kinestat
