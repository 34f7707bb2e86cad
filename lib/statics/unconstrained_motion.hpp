// The motion that shows why a case has no equilibrium.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// A motion of the bodies that the secondary actions cannot hold against the primaries and loads.
struct UnconstrainedMotion {
  BodyId body;             ///< the one that moves most
  Twist twist;             ///< its motion; only the axis and the pitch mean something
  std::vector<int> loads;  ///< the loads that do work on the motion, the largest work first
};

/// Finds, among the virtual motions on which no secondary action does work, the one on which the
/// primary actions and the loads do the most: a solution of the transposed system. Empty if
/// rounding hides it.
std::optional<UnconstrainedMotion> find_unconstrained_motion(const Mechanism& mechanism,
                                                             const CoordinateBasis& basis,
                                                             std::span<const Primary> primaries,
                                                             std::span<const BodyWrench> loads);

}  // namespace kinestat
