#include "studies/synthesis/positions/plane_area.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

double distance_from_side(const Point& point, const Point& from, const Point& to) {
  const Point side = to - from;
  const double square = std::norm(side);
  const double share = square > 0.0 ? std::clamp(dot(point - from, side) / square, 0.0, 1.0) : 0.0;
  return std::abs(point - from - share * side);
}

}  // namespace

PlaneArea::PlaneArea(std::vector<Point> corners) : corners_(std::move(corners)) {
  KINESTAT_EXPECTS(corners_.size() > 2);
  for (const Point& corner : corners_) {
    size_ = std::max(size_, std::abs(corner - corners_.front()));
  }
}

PlaneArea PlaneArea::between(const Point& one, const Point& other) {
  return PlaneArea({one, {other.real(), one.imag()}, other, {one.real(), other.imag()}});
}

// An odd number of sides lies to the right of it.
bool PlaneArea::holds(const Point& point) const {
  bool is_inside = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Point& from = corners_[i];
    const Point side = corners_[(i + 1) % corners_.size()] - from;
    const double above = point.imag() - from.imag();
    const bool crosses = (above < 0.0) != (above < side.imag());
    if (crosses && from.real() + above / side.imag() * side.real() > point.real()) {
      is_inside = !is_inside;
    }
  }
  return is_inside;
}

double PlaneArea::distance(const Point& point) const {
  if (holds(point)) {
    return 0.0;
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    least = std::min(least,
                     distance_from_side(point, corners_[i], corners_[(i + 1) % corners_.size()]));
  }
  return least <= kSameValue * size_ ? 0.0 : least;
}

}  // namespace kinestat
