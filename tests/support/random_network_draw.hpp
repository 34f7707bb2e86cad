// Draws points and directions as a random network lays them out.
#pragma once

#include "support/random.hpp"
#include "support/random_network_coupling.hpp"

namespace kinestat {

/// How the points and axes of a spatial network lie; all but `general` make redundant constraints.
enum class Layout {
  general,
  lattice,          ///< small whole coordinates, axes along x, y, z
  parallel_axes,    ///< every axis along one direction
  planar_in_space,  ///< a planar linkage in an oblique plane
  spherical,        ///< every axis through one point, often the origin
  planar            ///< space: planar
};

/// What all couplings of one network share, and the source of the rest. Types that have no axis
/// lie anywhere.
class LayoutDraw {
 public:
  LayoutDraw(Layout layout, Random& random);

  Layout layout() const { return layout_; }

  Space space() const { return layout_ == Layout::planar ? Space::planar : Space::spatial; }

  bool is_planar() const { return layout_ == Layout::planar; }

  Random& random() { return random_; }

  Vec3 point();

  /// On the axis of a coupling.
  Vec3 point_of(const NetworkDirection& axis);

  /// Common to all axes of the spherical layout.
  const Vec3& centre() const { return centre_; }

  /// Of an axis of turning.
  NetworkDirection turning();

  /// Of sliding, or the normal of a contact.
  NetworkDirection sliding();

  /// Perpendicular to another one.
  NetworkDirection across(const NetworkDirection& other);

  /// At an angle of 30 to 150 degrees to another one.
  NetworkDirection oblique_to(const NetworkDirection& other);

 private:
  NetworkDirection along_world(int first, int last);
  Vec3 perpendicular_to(const Vec3& axis);

  Layout layout_;
  Random& random_;
  Vec3 normal_;  ///< of the plane, or the direction of all axes
  Vec3 centre_;
};

}  // namespace kinestat
