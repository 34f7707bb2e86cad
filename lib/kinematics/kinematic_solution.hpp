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

/// A motion of bodies that no other body feels, which a case leaves open.
struct IdleFreedom {
  std::vector<BodyId> bodies;
  std::vector<int> freedoms;  ///< that it moves: indices into Topology::freedoms
};

/// Lists are parallel to those of the Topology; empty unless the status is solved. Twists are
/// written about the origin of the Geometry.
struct KinematicSolution {
  SolveStatus status = SolveStatus::solved;
  MotionCounts counts;
  RankEvidence evidence;           ///< of the velocity system, whose rank is m + λ (n - 1)
  double residual = 0.0;           ///< relative, of the velocity system
  AnswerEvidence answer;           ///< its bounds are those of the rates
  PrimaryCheck check;              ///< what is wrong with the primaries, if anything
  std::vector<double> rates;       ///< of each freedom [rad/s or m/s]
  std::vector<Twist> bodies;       ///< of each body relative to the ground
  std::vector<Twist> body_bounds;  ///< how far each component of them may be off, rounding of the
                                   ///< drawing included; 0 of typed numbers that are exact
  std::vector<Twist> couplings;    ///< of each coupling: head relative to tail
  std::vector<IdleFreedom> idle = {};  ///< at rest by assumption: what they move is not determined

  /// Whether the rate of a freedom is that of no idle one.
  bool knows_rate(int freedom) const;

  /// Whether no idle freedom moves the body.
  bool knows_body(BodyId body) const;
};

}  // namespace kinestat
