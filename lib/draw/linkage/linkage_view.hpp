// Where a drawing of a mechanism shows the points of the world.
#pragma once

#include <vector>

#include "draw/linkage/linkage_drawing.hpp"
#include "draw/linkage/linkage_parts.hpp"

namespace kinestat {

/// Parallel projection: the world point p is at (x0 + scale right·p, y0 - scale up·p).
struct LinkageView {
  Vec3 right = Vec3::UnitX();  ///< unit vectors, perpendicular to each other
  Vec3 up = Vec3::UnitY();
  double scale = 1.0;  ///< [px/m]
  double x0 = 0.0;     ///< [px]
  double y0 = 0.0;     ///< [px]

  PixelPoint at(const Vec3& p) const;

  /// A world vector on the picture [px].
  PixelPoint along(const Vec3& v) const;
};

/// The scale and the origin with which all points fit a picture of that width and usual height, its
/// middle at (0, 0).
LinkageView fit_view(LinkageView directions,
                     const std::vector<Vec3>& points,
                     double width = kDrawingWidth);

/// All places that a drawing must hold.
std::vector<Vec3> extent_points(const LinkageParts& parts,
                                const Analysis& analysis,
                                const LinkageOptions& options);

}  // namespace kinestat
