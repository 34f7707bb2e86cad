// The actions in a mechanism in one case.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/accuracy.hpp"
#include "core/solve_status.hpp"
#include "math/elimination/rank.hpp"
#include "mechanism/mechanism.hpp"
#include "network/freedom_counts.hpp"
#include "network/primary_check.hpp"
#include "screw/wrench.hpp"
#include "statics/friction_law.hpp"
#include "statics/self_stress.hpp"
#include "statics/unconstrained_motion.hpp"

namespace kinestat {

/// Friction of a coupling, of tail on head.
struct FrictionAction {
  CouplingId coupling;
  std::optional<BodyPair> between;  ///< which it loads; empty: the bodies of the coupling, whose
                                    ///< wrench includes it
  double magnitude = 0.0;           ///< [N·m or N], never negative
  bool is_couple = true;
  Wrench wrench;  ///< about the origin of the Geometry, against the motion
};

/// What presses in a coupling with friction although the file gives no dimension for it, so that it
/// has no friction.
struct IgnoredReaction {
  CouplingId coupling;
  Reaction reaction = Reaction::axial;
  double size = 0.0;  ///< [N or N·m]
};

/// The word in files and reports.
constexpr std::string_view word_of(IndeterminateChoice choice) {
  switch (choice) {
    case IndeterminateChoice::report:
      return "report";
    case IndeterminateChoice::minimum_norm:
      return "minimum_norm";
    case IndeterminateChoice::stiffness:
      return "stiffness";
  }
  return "";
}

/// Values of actions that equilibrium leaves open.
struct Completion {
  IndeterminateChoice by = IndeterminateChoice::report;  ///< report: there are none
  double length = 0.0;       ///< by which minimum norm divides couples [m]
  std::vector<int> actions;  ///< which have their value so, ascending
};

/// Lists are parallel to those of the Topology. An empty magnitude is not determined by
/// equilibrium, nor by what completes it. Wrenches are written about the origin of the Geometry.
/// Nothing is filled in where the status is dependent or inconsistent; of an inconsistent case, the
/// check has only those dependences that the primaries violate.
struct StaticSolution {
  SolveStatus status = SolveStatus::solved;
  ActionCounts counts;
  RankEvidence evidence;
  double residual = 0.0;  ///< relative, of the equilibrium system
  AnswerEvidence answer;  ///< its bounds are those of the magnitudes that are determined; none
                          ///< where friction or what completes equilibrium has a part in them
  PrimaryCheck check;
  std::vector<std::optional<double>> magnitudes;  ///< of each action [N·m or N]
  std::vector<std::optional<Wrench>> wrenches;    ///< of each coupling: tail on head, friction
                                                  ///< included; empty if one of its actions is
  std::vector<Wrench> wrench_bounds;     ///< how far each component of them may be off, rounding of
                                         ///< the drawing included
  std::vector<FrictionAction> friction;  ///< of the couplings that have any
  std::vector<CouplingId> at_rest;       ///< where friction has no direction
  std::vector<CouplingId> held_cables;   ///< drums at rest that an actuator holds: the friction of
                                         ///< their cables has no direction either, and is left out
  std::vector<CouplingId> open_friction;  ///< that depends on actions which equilibrium leaves open
  std::vector<VecX> other_actions;  ///< magnitudes of each action in other equilibria that fulfil
                                    ///< the laws of friction too [N·m or N]: beside the answer;
                                    ///< or, where it is inconsistent without friction, all of them
  std::vector<IgnoredReaction> ignored;   ///< in the order of mechanism.frictions
  std::vector<SelfStress> self_stresses;  ///< of an underdetermined case; empty also where
                                          ///< there are too many to be read
  Completion completion;
  std::optional<UnconstrainedMotion> unconstrained;  ///< of an inconsistent case
};

/// Whether the value of an action comes from what completes equilibrium.
bool is_completed(const StaticSolution& solution, int action);

/// Whether that of any action of the coupling does.
bool is_completed(const StaticSolution& solution, const CouplingTopology& coupling);

/// Whether the value is a convention (minimum norm) and no consequence of the loads.
bool is_by_convention(const StaticSolution& solution, int action);
bool is_by_convention(const StaticSolution& solution, const CouplingTopology& coupling);

}  // namespace kinestat
