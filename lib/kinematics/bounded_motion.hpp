// The motions of bodies and couplings with their error bounds.
#pragma once

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/bounded_screw.hpp"

namespace kinestat {

/// The rate of a freedom with its error bound. If the solution has no bounds, the bound is the
/// rounding of the rate itself.
BoundedNumber bounded_rate(const KinematicSolution& motion, int freedom);

/// The twist of the head of a coupling relative to its tail: the sum of its unit screws, each times
/// its rate.
BoundedTwist bounded_coupling(const Mechanism& mechanism,
                              const KinematicSolution& motion,
                              CouplingId coupling);

/// The twist of a body relative to the ground.
BoundedTwist bounded_body(const KinematicSolution& motion, BodyId body);

/// Computes the twists of the couplings and the error bounds of the twists of the bodies from the
/// rates. The bound of a body is the sum of the bounds of the couplings between it and the ground,
/// along the path with the fewest couplings, and of the difference between its own twist and the
/// sum of theirs. Components that are not larger than their bounds become zero.
void finish_motions(const Mechanism& mechanism, KinematicSolution& motion);

}  // namespace kinestat
