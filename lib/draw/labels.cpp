#include "draw/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/symbols.hpp"

namespace kinestat {

namespace {

// A side of a point: where the text begins or ends, and where its base line is.
struct Side {
  double x = 0.0;
  double y = 0.0;
  Anchor anchor = Anchor::start;
};

constexpr double kSlope = 0.7;

// Right above first, then clockwise.
constexpr std::array<Side, 8> kSides = {{
    {.x = kSlope, .y = -kSlope, .anchor = Anchor::start},
    {.x = 1.0, .y = 0.0, .anchor = Anchor::start},
    {.x = kSlope, .y = kSlope, .anchor = Anchor::start},
    {.x = 0.0, .y = 1.0, .anchor = Anchor::middle},
    {.x = -kSlope, .y = kSlope, .anchor = Anchor::end},
    {.x = -1.0, .y = 0.0, .anchor = Anchor::end},
    {.x = -kSlope, .y = -kSlope, .anchor = Anchor::end},
    {.x = 0.0, .y = -1.0, .anchor = Anchor::middle},
}};

constexpr std::array<double, 4> kDistances = {8.0, 18.0, 32.0, 50.0};

// From the middle of a line of text to its base line, as a share of its size.
constexpr double kMiddle = 0.3;

// The point of a box that is nearest to another point.
PixelPoint nearest(const PixelBox& box, PixelPoint point) {
  return {.x = std::clamp(point.x, box.left, box.right),
          .y = std::clamp(point.y, box.top, box.bottom)};
}

}  // namespace

void PointLabels::avoid(const std::vector<PixelPoint>& points) {
  constexpr double kApart = 3.0;
  avoid_each(points);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const PixelPoint between = points[i] - points[i - 1];
    const double length = length_of(between);
    for (double at = kApart; at < length; at += kApart) {  // never of a gap
      avoided_.push_back(points[i - 1] + (at / length) * between);
    }
  }
}

void PointLabels::avoid_each(const std::vector<PixelPoint>& points) {
  for (const PixelPoint& point : points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) {
      avoided_.push_back(point);
    }
  }
}

int PointLabels::cost(const PixelBox& box) const {
  const bool is_inside = box.left >= area_.left && box.right <= area_.right &&
                         box.top >= area_.top && box.bottom <= area_.bottom;
  const auto overlaps = [&box](const PixelBox& other) { return box.overlaps(other); };
  if (!is_inside || std::ranges::any_of(taken_, overlaps)) {
    return -1;
  }
  // Curves are as wide as that around their points.
  const PixelBox near = box.grown(2.0);
  return static_cast<int>(std::ranges::count_if(avoided_, [&near](const PixelPoint& point) {
    return point.x > near.left && point.x < near.right && point.y > near.top &&
           point.y < near.bottom;
  }));
}

bool PointLabels::write(PixelPoint point, std::string_view text, const TextStyle& style, Svg& svg) {
  TextStyle best_style = style;
  PixelPoint best_place;
  int best_cost = -1;
  double best_distance = 0.0;
  for (const double distance : kDistances) {
    for (const Side& side : kSides) {
      TextStyle trial = style;
      trial.anchor = side.anchor;
      const PixelPoint place = {.x = point.x + distance * side.x,
                                .y = point.y +
                                     (distance + (side.x == 0.0 ? style.size / 3 : 0.0)) * side.y +
                                     kMiddle * style.size};
      const int found = cost(text_box(place, text, trial));
      if (found >= 0 && (best_cost < 0 || found < best_cost)) {
        best_cost = found;
        best_style = trial;
        best_place = place;
        best_distance = distance;
      }
    }
    if (best_cost == 0) {
      break;
    }
  }
  if (best_cost < 0) {
    return false;
  }
  const PixelBox box = text_box(best_place, text, best_style);
  if (best_distance > kDistances[1]) {
    svg.line(point, nearest(box, point), {.stroke = Ink::soft, .width = 0.75});
  }
  svg.text(best_place, text, best_style);
  take(box);
  return true;
}

}  // namespace kinestat
