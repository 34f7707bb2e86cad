#include "draw/thinned_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "draw/symbols.hpp"

namespace kinestat {

namespace {

constexpr double kUnseen = 0.1;       // [px]
constexpr std::size_t kLongest = 64;  // points that are left out one after the other

// How far a point is from the part of a line between two others.
double distance(PixelPoint point, PixelPoint from, PixelPoint to) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double square = x * x + y * y;
  const double share =
      square > 0.0
          ? std::clamp(((point.x - from.x) * x + (point.y - from.y) * y) / square, 0.0, 1.0)
          : 0.0;
  return length_of(point - from - share * PixelPoint{.x = x, .y = y});
}

}  // namespace

std::vector<PixelPoint> thinned_line(std::span<const PixelPoint> points) {
  std::vector<PixelPoint> line;
  for (std::size_t begin = 0; begin < points.size();) {
    line.push_back(points[begin]);
    std::size_t end = begin + 1;
    const auto holds = [&](std::size_t next) {
      return next < points.size() && next <= begin + kLongest &&
             std::all_of(points.begin() + static_cast<std::ptrdiff_t>(begin) + 1,
                         points.begin() + static_cast<std::ptrdiff_t>(next),
                         [&](PixelPoint one) {
                           return distance(one, points[begin], points[next]) <= kUnseen;
                         });
    };
    // Mostly straight to its end.
    const std::size_t last = std::min(points.size() - 1, begin + kLongest);
    if (last > end && holds(last)) {
      end = last;
    }
    while (holds(end + 1)) {
      ++end;
    }
    begin = end;
  }
  return line;
}

}  // namespace kinestat
