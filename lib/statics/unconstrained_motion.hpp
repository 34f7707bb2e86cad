// A motion of the bodies that no action can hold against the loads.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// A motion of the bodies that the actions cannot hold against what is known.
struct UnconstrainedMotion {
  BodyId body;             ///< the one that moves most
  Twist twist;             ///< its motion; only the axis and the pitch mean something
  std::vector<int> loads;  ///< which loads do work on the motion, the largest work first
};

/// The virtual motion, reciprocal to every secondary action, on which the primary actions and the
/// loads do the most work: a solution of the transposed system. Empty if rounding hides it.
std::optional<UnconstrainedMotion> find_unconstrained_motion(const Mechanism& mechanism,
                                                             const CoordinateBasis& basis,
                                                             std::span<const Primary> primaries,
                                                             std::span<const BodyWrench> loads);

}  // namespace kinestat
