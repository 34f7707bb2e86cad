// The inertia of a mechanism as one of its freedoms feels it.
#pragma once

#include <optional>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Of each body what it adds to the equivalent inertia [kg·m²] or mass [kg] at a freedom, as drawn:
/// twice its kinetic energy over the square of the rate. Empty where the motion is not determined,
/// be it of one body that has mass or inertia, the freedom is at rest, or no body has any.
std::optional<std::vector<double>> equivalent_inertias(const Mechanism& mechanism,
                                                       const KinematicSolution& motion,
                                                       int freedom);

}  // namespace kinestat
