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

/// The friction of a coupling, by which its tail acts on its head.
struct FrictionAction {
  CouplingId coupling;
  std::optional<BodyPair> between;  ///< the bodies on which it acts; empty: those of the coupling,
                                    ///< whose wrench then includes it
  double magnitude = 0.0;           ///< [N·m or N], never negative
  bool is_couple = true;
  Wrench wrench;  ///< about the origin of the Geometry, against the motion
};

/// A reaction that presses in a coupling with friction, but causes no friction because the file
/// lacks a dimension for it.
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
  IndeterminateChoice by = IndeterminateChoice::report;  ///< report: no action has such a value
  double length = 0.0;       ///< by which the minimum norm divides couples [m]
  std::vector<int> actions;  ///< the actions with such a value, ascending
};

/// The answer of the statics. Lists are parallel to those of the Topology. A magnitude is empty if
/// neither equilibrium nor its completion determines it. Wrenches are written about the origin of
/// the Geometry. Nothing is filled in if the status is dependent or inconsistent; the check of an
/// inconsistent case has only the dependences that the primaries violate.
struct StaticSolution {
  SolveStatus status = SolveStatus::solved;
  ActionCounts counts;
  RankEvidence evidence;
  double residual = 0.0;  ///< relative, of the equilibrium system
  AnswerEvidence answer;  ///< with error bounds of the determined magnitudes; without bounds if
                          ///< friction or the completion of equilibrium affects them
  PrimaryCheck check;
  std::vector<std::optional<double>> magnitudes;  ///< of each action [N·m or N]
  std::vector<std::optional<Wrench>> wrenches;    ///< of each coupling: tail on head, friction
                                                  ///< included; empty if one of its actions is
  std::vector<Wrench> wrench_bounds;      ///< error bounds of their components, which include the
                                          ///< rounding of the drawn dimensions
  std::vector<FrictionAction> friction;   ///< of the couplings that have friction
  std::vector<CouplingId> at_rest;        ///< couplings at rest, whose friction has no direction
  std::vector<CouplingId> held_cables;    ///< drums at rest that an actuator holds: the friction of
                                          ///< their cables has no direction either, and is left out
  std::vector<CouplingId> open_friction;  ///< couplings whose friction depends on open actions
  std::vector<VecX> other_actions;  ///< other equilibria that also satisfy the laws of friction:
                                    ///< magnitudes of each action [N·m or N]. If the case is
                                    ///< inconsistent without friction, these are all equilibria
  std::vector<IgnoredReaction> ignored;   ///< in the order of mechanism.frictions
  std::vector<SelfStress> self_stresses;  ///< of an underdetermined case; also empty if there
                                          ///< are too many to be read
  Completion completion;
  std::optional<UnconstrainedMotion> unconstrained;  ///< of an inconsistent case
};

/// Whether the value of an action comes from the completion of equilibrium.
bool is_completed(const StaticSolution& solution, int action);

/// Whether this holds for any action of the coupling.
bool is_completed(const StaticSolution& solution, const CouplingTopology& coupling);

/// Whether the value is a convention (minimum norm) and no consequence of the loads.
bool is_by_convention(const StaticSolution& solution, int action);
bool is_by_convention(const StaticSolution& solution, const CouplingTopology& coupling);

}  // namespace kinestat
