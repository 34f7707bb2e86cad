// Cases that leave open only freedoms that no other body feels.
#pragma once

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// If the known motions of a case leave only idle freedoms open, such as the spin of a rod between
/// two ball joints: adds a rate of zero for each of them to the known motions, which determines all
/// others, and returns the idle freedoms. If more is open, or if there is friction in what an idle
/// freedom moves, returns nothing and leaves the case as it was.
std::vector<IdleFreedom> hold_idle_freedoms(const Mechanism& mechanism,
                                            const CoordinateBasis& basis,
                                            const KinematicSolution& open,
                                            Case& which);

/// The same for a gear, which may leave open every motion that is possible while its inputs and
/// engaged elements are at rest, such as that of a shaft with no engaged element. Friction there
/// has no direction; it leaves only actions open.
std::vector<IdleFreedom> hold_beside_gear(const Mechanism& mechanism,
                                          const CoordinateBasis& basis,
                                          const KinematicSolution& open,
                                          Case& which);

}  // namespace kinestat
