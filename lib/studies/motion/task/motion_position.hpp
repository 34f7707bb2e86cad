// Everything that is known of one position of a finite motion.
#pragma once

#include <optional>
#include <vector>

#include "cases/analysis.hpp"
#include "cases/case_passes.hpp"
#include "core/motion_tolerance.hpp"
#include "studies/motion/motion_state.hpp"
#include "studies/motion/task/case_speeds.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// What is worked out at a position beside its poses.
struct MotionDetail {
  bool velocity = false;
  bool acceleration = false;
  bool statics = false;           ///< actions, and the powers and ratios of the case
  bool reduced_equation = false;  ///< that of a case with inertia, and its second method
  bool transmission_angle = false;
  double closure_error = kMotionClosure;  ///< of the worst position of the motion

  bool operator==(const MotionDetail&) const = default;
};

/// As share of the mechanism's size, no less than what counts as closed. A mechanism that closes by
/// least squares may close exactly where it was drawn, and is no more exact for that.
double worst_closure_error(const MotionSolution& solution);

/// World frame, SI. Lists are parallel to those of the topology.
struct MotionPosition {
  std::vector<std::optional<double>> freedoms;     ///< positions [rad or m]
  std::vector<double> turns;                       ///< of the bodies in the plane, counted [rad]
  std::optional<double> time = {};                 ///< since the motion began [s]
  MotionState state;                               ///< with the speeds of the case, or per share
  SpeedsKnown speeds = SpeedsKnown::not_by_state;  ///< what the case says of them
  std::optional<CaseAnalysis> solved;              ///< the passes of the case; its motion alone
                                                   ///< where velocities are missing
  std::optional<CaseAnalysis> without_friction;    ///< where a drive rests and frictions have no
                                                   ///< direction: what acts without these
  std::optional<double> transmission_angle;        ///< [rad]
  std::vector<Vec3> drive_directions = {};  ///< of each actuator whose action is solved the unit
                                            ///< force on the head of its coupling; zero: a couple

  /// The same, with what acts without friction where it has no direction.
  MotionPosition or_without_friction() const;

  /// The state has those of the case.
  bool has_speeds() const { return speeds == SpeedsKnown::all; }
};

/// Empty otherwise are its velocities.
inline bool has_motion(const MotionPosition& position) {
  return position.has_speeds() && !position.state.is_singular;
}

/// Whether a drive of a motion in time rests there, perhaps while others move.
bool has_drive_at_rest(const MotionPlan& plan, const MotionPosition& position);

/// What acts with the losses of meshes; null where the mechanism has none, or they lock, or
/// equilibrium leaves them open.
inline const LossyState* lossy_state_of(const CaseAnalysis& solved) {
  return solved.efficiency && solved.efficiency->state ? &*solved.efficiency->state : nullptr;
}

inline const LossyState* lossy_state_of(const MotionPosition& position) {
  return position.solved ? lossy_state_of(*position.solved) : nullptr;
}

/// Works them out one after the other.
class MotionPositions {
 public:
  MotionPositions(const Mechanism& mechanism,
                  const MotionPlan& plan,
                  const MotionNetwork& network,
                  std::span<const DrawnCoupling> drawn,
                  const MotionDetail& detail);

  /// At a share of the motion; in time, when it is there, unless `time` says it, as share of the
  /// whole time.
  MotionPosition at(const Configuration& configuration,
                    double share,
                    std::optional<double> time = {});

  /// The mechanism in the position that was asked for last.
  const Mechanism& moved() const { return moved_; }

 private:
  Case case_at(double time) const;
  void hold_known(const Case& which, MotionState& state) const;
  void place(const Configuration& configuration, MotionPosition& position);
  void move(const Configuration& configuration, MotionPosition& position);
  void solve_passes(const Configuration& configuration,
                    const GivenSpeeds& speeds,
                    MotionPosition& position);
  void solve_at_rest(const Case& which, const KnownState& known, MotionPosition& position);
  bool has_own_rank() const;
  bool has_motion_of_state(const Case& which) const;
  bool loads_by_speed(const Case& which) const;
  KinematicSolution motion_of_state(const MotionPosition& position) const;

  const Mechanism& mechanism_;
  const MotionPlan& plan_;
  const MotionNetwork& network_;
  std::span<const DrawnCoupling> drawn_;
  MotionDetail detail_;
  const Case* which_ = nullptr;
  std::optional<Case> now_;  // with the speeds of a motion in time
  Mechanism moved_;
  MotionStates states_;
};

}  // namespace kinestat
