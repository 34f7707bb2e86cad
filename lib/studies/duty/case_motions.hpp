// The velocities of a case as functions of its known motions.
#pragma once

#include <span>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/bounded_screw.hpp"

namespace kinestat {

/// Velocities are linear in the known ones, so that each of these is solved once.
class CaseMotions {
 public:
  CaseMotions(const Mechanism& mechanism, const Case& which);

  bool is_solved() const { return is_solved_; }

  /// Of a freedom, for these known motions; zero where rounding does not tell it from that.
  double rate(int freedom, std::span<const double> known) const;

  /// The angular velocity of a body relative to another, about the ground's axes.
  Vec3 turning(BodyId body, BodyId base, std::span<const double> known) const;

  /// Of a body about the origin of the geometry.
  Twist body(BodyId body, std::span<const double> known) const;

 private:
  std::vector<KinematicSolution> units_;  ///< for a magnitude of 1 of one known motion
  bool is_solved_ = true;
};

}  // namespace kinestat
