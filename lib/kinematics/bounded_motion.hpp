// The motions of bodies and couplings with how far they may be off.
#pragma once

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/bounded_screw.hpp"

namespace kinestat {

/// A rate with its bound: that of the solution, where there is one.
BoundedNumber bounded_rate(const KinematicSolution& motion, int freedom);

/// Head relative to tail: the sum of the unit screws of the coupling, each times its rate.
BoundedTwist bounded_coupling(const Mechanism& mechanism,
                              const KinematicSolution& motion,
                              CouplingId coupling);

/// Relative to the ground.
BoundedTwist bounded_body(const KinematicSolution& motion, BodyId body);

/// Makes the motions of the couplings and the bounds of those of the bodies from the rates: a body
/// moves as the couplings between it and the ground do one after the other, over the fewest of
/// them. By how far its own solution misses that sum counts too. What its bound does not tell from
/// zero is zero then.
void finish_motions(const Mechanism& mechanism, KinematicSolution& motion);

}  // namespace kinestat
