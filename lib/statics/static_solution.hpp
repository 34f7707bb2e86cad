// The actions in a mechanism in one case.
#pragma once

#include <optional>
#include <vector>

#include "core/solve_status.hpp"
#include "core/types.hpp"
#include "math/rank.hpp"
#include "network/counts.hpp"
#include "network/primary_check.hpp"
#include "screw/wrench.hpp"

namespace kinestat {

/// A motion of the bodies that the actions cannot hold against the load.
struct UnheldMotion {
  BodyId body;  ///< the one that moves most
  Twist twist;  ///< its motion; only the axis and the pitch mean something
};

/// Lists are parallel to those of the Topology. An empty magnitude is not determined by
/// equilibrium. Wrenches are written about the origin of the Geometry. Nothing is filled in where
/// the status is dependent or inconsistent.
struct StaticSolution {
  SolveStatus status = SolveStatus::solved;
  ActionCounts counts;
  RankEvidence evidence;
  double residual = 0.0;  ///< relative, of the equilibrium system
  PrimaryCheck check;
  std::vector<std::optional<double>> magnitudes;  ///< of each action [N·m or N]
  std::vector<std::optional<Wrench>> wrenches;    ///< of each coupling: tail on head; empty if one
                                                  ///< of its actions is
  std::optional<UnheldMotion> unheld;             ///< of an inconsistent case
};

}  // namespace kinestat
