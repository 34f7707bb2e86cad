// Actions in a mechanism whose couplings have friction.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "statics/friction_law.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Solves for the actions together with the friction that they cause: f_i = law_i(ψ(f)), in which
/// ψ is affine in f. The friction grows from nothing to its full size while the solution is
/// followed, so that of several solutions the one that belongs to the motion is found. Where the
/// actions grow without bound before it has its full size, the status is `locked`. Where that
/// solution would have surfaces pull on each other that can only push, or there is none, the one in
/// which they push counts, if there is one. The friction of
/// a law that needs an action which equilibrium leaves open is open too, and so is every action
/// that depends on it: they count as undetermined and have no value.
[[nodiscard]] StaticSolution solve_with_friction(const Mechanism& mechanism,
                                                 const CoordinateBasis& basis,
                                                 std::span<const Primary> primaries,
                                                 std::span<const BodyWrench> loads,
                                                 std::span<const FrictionLaw> laws);

}  // namespace kinestat
