// BodyPose: where a body stands, as the displacement from where it was drawn.
#pragma once

#include "screw/wrench.hpp"

namespace kinestat {

using Mat3 = Eigen::Matrix3d;

/// Takes a point of the body from its drawn place to `rotation * point + shift`, in the world
/// frame [m]. The shift is that of the body's point at the world origin.
struct BodyPose {
  Mat3 rotation = Mat3::Identity();
  Vec3 shift = Vec3::Zero();  ///< [m]

  /// Where a point of the body is that was drawn at `drawn`.
  Vec3 point(const Vec3& drawn) const { return rotation * drawn + shift; }

  /// Where a direction fixed in the body points.
  Vec3 direction(const Vec3& drawn) const { return rotation * drawn; }

  BodyPose inverse() const {
    return {.rotation = rotation.transpose(), .shift = -(rotation.transpose() * shift)};
  }

  /// First b, then a.
  friend BodyPose operator*(const BodyPose& a, const BodyPose& b) {
    return {.rotation = a.rotation * b.rotation, .shift = a.point(b.shift)};
  }

  /// A screw fixed in the body, about the world origin before and after.
  Twist moved(const Twist& drawn) const {
    const Vec3 angular = rotation * drawn.angular;
    return {.angular = angular, .linear = rotation * drawn.linear + shift.cross(angular)};
  }

  Wrench moved(const Wrench& drawn) const {
    const Vec3 force = rotation * drawn.force;
    return {.moment = rotation * drawn.moment + shift.cross(force), .force = force};
  }
};

}  // namespace kinestat
