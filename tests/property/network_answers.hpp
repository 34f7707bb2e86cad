// The answers of a network as screws, which do not depend on how its file names and directs things.
#pragma once

#include "property/network_case.hpp"

namespace kinestat {

/// The magnitudes as a vector; empty ones fail the test.
VecX rates_of(const KinematicSolution& solution);
VecX magnitudes_of(const StaticSolution& solution);

/// Screws about the world origin, whatever the mechanism's is; [ω; v_O] or [T_O; F] in columns.

/// The twist of every body (6 x n).
Mat6X body_twists(const Mechanism& mechanism, const KinematicSolution& solution);

/// The twist of every coupling as the sum of its freedoms (6 x e), head relative to tail.
Mat6X coupling_twists(const Mechanism& mechanism, const VecX& rates);

/// The wrench of every coupling as the sum of its actions (6 x e), tail on head.
Mat6X coupling_wrenches(const Mechanism& mechanism, const VecX& magnitudes);

/// The part of it that is the actuator's (6 x actuators).
Mat6X internal_wrenches(const Mechanism& mechanism, const VecX& magnitudes);

/// The rates at which the couplings have the given twists: the freedoms of a coupling are
/// independent. `length` weighs linear against angular velocities; 0: the network's.
VecX freedom_rates(const NetworkCase& network, const Mat6X& twists, double length = 0.0);

/// The magnitudes of the actions of which the couplings bear the given wrenches, `internal` being
/// the part of the actuators: the constraints of a coupling are independent. `length` likewise.
VecX action_magnitudes(const NetworkCase& network,
                       const Mat6X& wrenches,
                       const Mat6X& internal,
                       double length = 0.0);

}  // namespace kinestat
