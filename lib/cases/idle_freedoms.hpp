// Cases that leave open only what no other body feels.
#pragma once

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Where the known motions of a case leave nothing open but idle freedoms, as the spin of a rod
/// between two balls: adds to them that one rate of each is zero, by which all other motions are
/// determined, and answers what is idle. Empty, and the case as it was, where more is open, or
/// where something rubs in what an idle freedom moves.
std::vector<IdleFreedom> hold_idle_freedoms(const Mechanism& mechanism,
                                            const CoordinateBasis& basis,
                                            const KinematicSolution& open,
                                            Case& which);

/// Likewise of a gear, which may leave open more than that: whatever moves while its inputs and
/// engaged elements rest, as another shaft on which nothing turns that is engaged. What rubs there
/// has no direction, and leaves open the actions alone.
std::vector<IdleFreedom> hold_beside_gear(const Mechanism& mechanism,
                                          const CoordinateBasis& basis,
                                          const KinematicSolution& open,
                                          Case& which);

}  // namespace kinestat
