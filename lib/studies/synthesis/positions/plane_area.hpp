// A polygon in which points may lie.
#pragma once

#include <vector>

#include "studies/synthesis/positions/plane.hpp"

namespace kinestat {

/// Its corners in order, in either sense; sides that cross each other leave out what they enclose
/// twice.
class PlaneArea {
 public:
  explicit PlaneArea(std::vector<Point> corners);

  /// A rectangle along the axes, by two opposite corners.
  static PlaneArea between(const Point& one, const Point& other);

  /// How far a point lies outside; zero within and on the rim, for which rounding does not count.
  double distance(const Point& point) const;

 private:
  bool holds(const Point& point) const;

  std::vector<Point> corners_;
  double size_ = 0.0;  // the largest distance of a corner from the first
};

}  // namespace kinestat
