// Where the origin of a mechanism's own frame lies in the world.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// What points of a mechanism are measured from and its screws are written about: the origin of the
/// world, unless the mechanism stands far away from it. It is no point itself, so that none is
/// shifted by hand: points and screws are local until they are reported, and only in_world and
/// about_world lead out.
class LocalOrigin {
 public:
  LocalOrigin() = default;

  explicit LocalOrigin(const Vec3& place) : place_(place) {}

  /// In the world [m].
  const Vec3& place() const { return place_; }

  bool is_world() const { return place_.isZero(0.0); }

  /// Where a local point lies in the world [m].
  template <class Scalar = double>
  Vec3Of<Scalar> in_world(const Vec3In<Scalar>& point) const {
    return point + place_.template cast<Scalar>();
  }

 private:
  Vec3 place_ = Vec3::Zero();
};

}  // namespace kinestat
