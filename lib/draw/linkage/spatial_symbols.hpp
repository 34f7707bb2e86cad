// Symbols of couplings in space, seen in parallel projection.
#pragma once

#include <vector>

#include "draw/linkage/linkage_canvas.hpp"

namespace kinestat {

/// What the symbol of a coupling needs.
struct SpatialSymbol {
  CouplingType type = CouplingType::revolute;
  Vec3 at = Vec3::Zero();       ///< [m]
  std::vector<Vec3> axes;       ///< unit vectors of its freedoms
  Vec3 normal = Vec3::UnitZ();  ///< of a contact
  Ink ink = Ink::ink;           ///< of the body that moves
};

/// A circle around an axis, radius in pixels, as an ellipse of points.
std::vector<PixelPoint> circle_in_space(const LinkageView& view,
                                        const Vec3& centre,
                                        const Vec3& axis,
                                        double radius);

/// A cylinder for what turns, a box for what slides, a ball, a cross, a plate for others.
void draw_spatial_coupling(Svg& svg, const LinkageView& view, const SpatialSymbol& symbol);

}  // namespace kinestat
