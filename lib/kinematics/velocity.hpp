// Velocities from primary motions by Davies' method.
#pragma once

#include <span>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Solves M_N φ = 0 for the secondary motions, given the primary ones (Cazangi 2008, sections 3.8.1
/// and 3.9.1), on the node system, which has the same solutions. `basis` must hold all unit
/// motions. The status is `dependent` if primaries follow from each other (even if they agree),
/// otherwise `underdetermined` if some motion is left open. `request` says how many digits the
/// rates and the twists of the bodies, about the origin of the geometry, must have.
[[nodiscard]] KinematicSolution solve_velocity(const Mechanism& mechanism,
                                               const CoordinateBasis& basis,
                                               std::span<const Primary> primaries,
                                               const AccuracyRequest& request = {});

}  // namespace kinestat
