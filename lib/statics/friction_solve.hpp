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

/// The primaries must be independent.
struct FrictionBalance {
  const Mechanism& mechanism;
  const CoordinateBasis& basis;
  std::span<const Primary> primaries;
  std::span<const BodyWrench> loads;  ///< without these frictions in balance
  std::span<const FrictionLaw> laws;
  std::span<const std::vector<BodyWrench>> along;  ///< of each, what a unit of it makes of forces
                                                   ///< of inertia and other loads
};

enum class FrictionOutcome {
  solved,
  none,     ///< friction that grows with what it causes has no end (Painleve)
  several,  ///< it balances in several ways
  open      ///< what presses follows from no equilibrium
};

struct FrictionMagnitudes {
  FrictionOutcome outcome = FrictionOutcome::solved;
  VecX values;                          ///< of each law [N·m or N]; where solved
  std::optional<CouplingId> open = {};  ///< of which
};

/// f_i = law_i(actions(f)).
FrictionMagnitudes solve_friction_balance(const FrictionBalance& given);

/// Reactions of the coupling of a law that press without friction, where all its actions are known.
std::vector<IgnoredReaction> ignored_reactions(const Mechanism& mechanism,
                                               const FrictionLaw& law,
                                               std::span<const std::optional<double>> magnitudes);

}  // namespace kinestat
