#include "draw/linkage/linkage_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kinestat {

namespace {

constexpr double kCanvasHeight = 460.0;  // [px]

struct Extent {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
};

// Of the points along right, up and what comes out of the picture.
Extent extent_of(const LinkageView& view, const std::vector<Vec3>& points) {
  Extent extent;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p(view.right.dot(points[i]), view.up.dot(points[i]), 0.0);
    extent.low = i == 0 ? p : Vec3(extent.low.cwiseMin(p));
    extent.high = i == 0 ? p : Vec3(extent.high.cwiseMax(p));
  }
  return extent;
}

void add_circle(const Wheel& wheel, std::vector<Vec3>& points) {
  const Vec3 one = wheel.axis.unitOrthogonal();
  const Vec3 other = wheel.axis.cross(one);
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::numbers::pi / 4;
    points.push_back(wheel.centre +
                     wheel.radius * (std::cos(angle) * one + std::sin(angle) * other));
  }
}

}  // namespace

PixelPoint LinkageView::at(const Vec3& p) const {
  return {.x = x0 + scale * right.dot(p), .y = y0 - scale * up.dot(p)};
}

PixelPoint LinkageView::along(const Vec3& v) const {
  return {.x = scale * right.dot(v), .y = -scale * up.dot(v)};
}

LinkageView fit_view(LinkageView directions, const std::vector<Vec3>& points, double width) {
  const Extent extent = extent_of(directions, points);
  const Vec3 size = extent.high - extent.low;
  LinkageView view = directions;
  double scale = std::numeric_limits<double>::infinity();
  if (size.x() > 0.0) {
    scale = std::min(scale, width / size.x());
  }
  if (size.y() > 0.0) {
    scale = std::min(scale, kCanvasHeight / size.y());
  }
  view.scale = std::isfinite(scale) ? scale : kCanvasHeight;
  const Vec3 middle = (extent.low + extent.high) / 2;
  view.x0 = -view.scale * middle.x();
  view.y0 = view.scale * middle.y();
  return view;
}

std::vector<Vec3> extent_points(const LinkageParts& parts,
                                const Analysis& analysis,
                                const LinkageOptions& options) {
  std::vector<Vec3> points = options.reach;
  for (const std::vector<BodyPoint>& of_body : parts.points) {
    for (const BodyPoint& point : of_body) {
      points.push_back(point.at);
    }
  }
  for (const std::vector<Vec3>& outline : parts.outlines) {
    points.insert(points.end(), outline.begin(), outline.end());
  }
  for (const Wheel& wheel : parts.wheels) {
    add_circle(wheel, points);
  }
  for (const TracedPath& path : options.paths) {
    points.insert(points.end(), path.points.begin(), path.points.end());
  }
  if (options.which && *options.which < analysis.cases.size()) {
    for (const Load& load : analysis.cases[*options.which].which.loads) {
      if (load.point) {
        points.push_back(*load.point);
      }
    }
  }
  return points;
}

}  // namespace kinestat
