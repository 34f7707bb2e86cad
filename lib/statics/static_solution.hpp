// The actions in a mechanism in one case.
#pragma once

#include <optional>
#include <vector>

#include "core/solve_status.hpp"
#include "math/rank.hpp"
#include "network/counts.hpp"
#include "network/primary_check.hpp"
#include "screw/wrench.hpp"
#include "statics/unheld_motion.hpp"

namespace kinestat {

/// Friction of a coupling, of tail on head.
struct FrictionAction {
  CouplingId coupling;
  double magnitude = 0.0;  ///< [N·m or N], never negative
  bool is_couple = true;
  Wrench wrench;  ///< about the origin of the Geometry, against the motion
};

/// Lists are parallel to those of the Topology. An empty magnitude is not determined by
/// equilibrium. Wrenches are written about the origin of the Geometry. Nothing is filled in where
/// the status is dependent or inconsistent; of an inconsistent case, the check has only those
/// dependences that the primaries violate.
struct StaticSolution {
  SolveStatus status = SolveStatus::solved;
  ActionCounts counts;
  RankEvidence evidence;
  double residual = 0.0;  ///< relative, of the equilibrium system
  PrimaryCheck check;
  std::vector<std::optional<double>> magnitudes;  ///< of each action [N·m or N]
  std::vector<std::optional<Wrench>> wrenches;    ///< of each coupling: tail on head, friction
                                                  ///< included; empty if one of its actions is
  std::vector<FrictionAction> friction;           ///< of the couplings that have any
  std::vector<CouplingId> at_rest;                ///< where friction has no direction
  std::optional<UnheldMotion> unheld;             ///< of an inconsistent case
};

}  // namespace kinestat
