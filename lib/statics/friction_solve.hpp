// Actions in a mechanism whose couplings have friction.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "statics/friction_law.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Solves for the actions together with the friction that they cause: f_i = law_i(ψ(f)), where the
/// actions ψ are affine in the friction magnitudes f. The friction is increased from zero to its
/// full size while the solution is followed; if there are several solutions, this finds the one
/// that belongs to the motion. If the actions grow without bound on the way, the status is
/// `locked`. If the solution does not exist, or has surfaces that pull on each other, a solution in
/// which all of them push is taken instead, if there is one. A law that depends on an action which
/// equilibrium leaves open is open itself, and so is every action that depends on its friction:
/// they count as undetermined and have no value.
[[nodiscard]] StaticSolution solve_with_friction(const Mechanism& mechanism,
                                                 const CoordinateBasis& basis,
                                                 std::span<const Primary> primaries,
                                                 std::span<const BodyWrench> loads,
                                                 std::span<const FrictionLaw> laws);

/// The equations of solve_friction_balance. The primaries must be independent.
struct FrictionBalance {
  const Mechanism& mechanism;
  const CoordinateBasis& basis;
  std::span<const Primary> primaries;
  std::span<const BodyWrench> loads;  ///< must be in balance without the friction
  std::span<const FrictionLaw> laws;
  std::span<const std::vector<BodyWrench>> along;  ///< of each law: the inertia forces and other
                                                   ///< loads that one unit of friction causes
};

enum class FrictionOutcome {
  solved,
  none,     ///< no magnitudes balance, as friction and its effect increase each other (Painleve)
  several,  ///< several sets of magnitudes balance
  open      ///< equilibrium does not determine the forces that press
};

struct FrictionMagnitudes {
  FrictionOutcome outcome = FrictionOutcome::solved;
  VecX values;                          ///< of each law [N·m or N], if solved
  std::optional<CouplingId> open = {};  ///< the coupling whose pressing forces are open
};

/// Finds magnitudes f of the friction with f_i = law_i(actions(f)).
FrictionMagnitudes solve_friction_balance(const FrictionBalance& given);

/// The reactions in the coupling of a law that press without causing friction. There are none if an
/// action of the coupling is not known.
std::vector<IgnoredReaction> ignored_reactions(const Mechanism& mechanism,
                                               const FrictionLaw& law,
                                               std::span<const std::optional<double>> magnitudes);

}  // namespace kinestat
