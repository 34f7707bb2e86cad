// The velocities of a mechanism in one case.
#pragma once

#include <vector>

#include "core/accuracy.hpp"
#include "core/solve_status.hpp"
#include "math/elimination/rank.hpp"
#include "network/freedom_counts.hpp"
#include "network/primary_check.hpp"
#include "screw/twist.hpp"

namespace kinestat {

/// A motion that a case leaves open and that no other body feels, such as the spin of a rod between
/// two ball joints.
struct IdleFreedom {
  std::vector<BodyId> bodies;
  std::vector<Twist> twists;  ///< of each of them, about the origin of the Geometry
  std::vector<int> freedoms;  ///< those with a rate in it: indices into Topology::freedoms
};

/// The answer of the kinematics. Lists are parallel to those of the Topology, and empty unless the
/// status is solved. Twists are written about the origin of the Geometry.
struct KinematicSolution {
  SolveStatus status = SolveStatus::solved;
  MotionCounts counts;
  RankEvidence evidence;           ///< of the velocity system, whose rank is m + λ (n - 1)
  double residual = 0.0;           ///< relative, of the velocity system
  AnswerEvidence answer;           ///< with error bounds of the rates
  PrimaryCheck check;              ///< what is wrong with the primaries, if anything
  std::vector<double> rates;       ///< of each freedom [rad/s or m/s]
  std::vector<Twist> bodies;       ///< of each body relative to the ground
  std::vector<Twist> body_bounds;  ///< error bounds of their components, which include the rounding
                                   ///< of the drawn dimensions; 0 if the typed numbers are exact
  std::vector<Twist> couplings;    ///< of each coupling: head relative to tail
  std::vector<IdleFreedom> idle = {};  ///< assumed at rest: the motions in them are not determined

  /// Whether the rate of a freedom is determined: no idle freedom changes it.
  bool knows_rate(int freedom) const;

  /// Whether the motion of a body is determined: no idle freedom moves it.
  bool knows_body(BodyId body) const;

  /// Whether the angular velocity of a body is: it is where an idle freedom only shifts it. The
  /// length is that of the mechanism.
  bool knows_turn(BodyId body, double length) const;

  /// Whether the velocity of a point of a body [m] is: it is on the axis of an idle spin.
  bool knows_velocity(BodyId body, const Vec3& point, double length) const;
};

}  // namespace kinestat
