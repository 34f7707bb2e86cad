// Values for actions that equilibrium leaves open, by what is asked for beside it.
#pragma once

#include <span>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Adds to an underdetermined solution its self-stresses and, if mechanism.indeterminate asks for
/// it, values of the open actions; any other solution stays as it is. Friction that was found
/// counts as known.
///
/// Minimum norm: of all actions in equilibrium those with the least sum of squares, couples divided
/// by the mechanism's length. It is a convention, so the status stays `underdetermined`.
/// Stiffness: those with the least complementary energy ½ Σ ψ²/k, ψ being in equilibrium, which are
/// compatible with elastic couplings that fit without load (Castigliano, Menabrea). Actions without
/// a stiffness are rigid; what these leave open stays open. If nothing does, the status is
/// `solved`.
[[nodiscard]] StaticSolution resolve_indeterminacy(const Mechanism& mechanism,
                                                   const CoordinateBasis& basis,
                                                   std::span<const Primary> primaries,
                                                   std::span<const BodyWrench> loads,
                                                   StaticSolution solution);

}  // namespace kinestat
