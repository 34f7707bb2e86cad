// Loads where their bodies have moved.
#pragma once

#include "mechanism/cases/load.hpp"
#include "mechanism/cases/moving_load.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// Where the force of a load acts once its body stands at `pose`; empty for a couple alone.
inline std::optional<Vec3> moved_point(const std::optional<Vec3>& drawn, const BodyPose& pose) {
  return drawn ? std::optional(pose.point(*drawn)) : std::nullopt;
}

/// The wrench of a drawn load once its body stands at `pose`.
inline Wrench moved_wrench(const Load& drawn, const BodyPose& pose) {
  const Wrench& wrench = drawn.acts.wrench;
  const bool turns = drawn.frame == LoadFrame::body;
  if (!drawn.point) {
    return turns ? Wrench{.moment = pose.direction(wrench.moment), .force = wrench.force} : wrench;
  }
  const Vec3 force = turns ? pose.direction(wrench.force) : wrench.force;
  const Vec3 couple = couple_of(drawn);
  return {
      .moment = pose.point(*drawn.point).cross(force) + (turns ? pose.direction(couple) : couple),
      .force = force};
}

/// Moves a load that follows curves from where it was drawn to where its body stands at `pose`.
inline void move_load(const MovingLoad& drawn, const BodyPose& pose, MovingLoad& moved) {
  moved.point = moved_point(drawn.point, pose);
  if (drawn.frame == LoadFrame::body) {
    moved.turn = pose.rotation;
  }
}

}  // namespace kinestat
