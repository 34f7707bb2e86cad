// Values of actions that equilibrium leaves open, by minimum norm or stiffness.
#pragma once

#include <span>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Adds to an underdetermined solution its self-stresses and, if mechanism.indeterminate asks for
/// them, values of the open actions. Any other solution stays as it is. The friction of the
/// solution counts as known.
///
/// Minimum norm takes, of all actions in equilibrium, those with the least sum of squares; couples
/// are divided by the length of the mechanism. This is a convention, so the status stays
/// `underdetermined`. Stiffness takes those with the least complementary energy ½ Σ ψ²/k: they are
/// compatible with elastic couplings that fit together without load (Castigliano, Menabrea).
/// Actions without a stiffness are rigid, and may leave some actions open. If none is open, the
/// status is `solved`.
[[nodiscard]] StaticSolution resolve_indeterminacy(const Mechanism& mechanism,
                                                   const CoordinateBasis& basis,
                                                   std::span<const Primary> primaries,
                                                   std::span<const BodyWrench> loads,
                                                   StaticSolution solution);

}  // namespace kinestat
