// The moment of a load about the origin of a mechanism.
#pragma once

#include <cmath>

#include "core/tolerance.hpp"
#include "core/types.hpp"

namespace kinestat {

/// The moment [N·m] of a force [N] at a point [m], and of a couple. A component within the rounding
/// of its products of coordinates and forces is zero.
inline Vec3 moment_of_load(const Vec3& point, const Vec3& force, const Vec3& couple) {
  const Vec3 p = point.cwiseAbs();
  const Vec3 f = force.cwiseAbs();
  const Vec3 terms(
      p.y() * f.z() + p.z() * f.y(), p.z() * f.x() + p.x() * f.z(), p.x() * f.y() + p.y() * f.x());
  Vec3 moment = point.cross(force) + couple;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double rounding = 4.0 * kEpsilon * (terms[i] + std::abs(couple[i]));
    moment[i] = std::isfinite(rounding) && std::abs(moment[i]) <= rounding ? 0.0 : moment[i];
  }
  return moment;
}

}  // namespace kinestat
