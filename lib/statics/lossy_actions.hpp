// Actions in a mechanism whose meshes lose power, and whose couplings may have friction.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "statics/mesh_loss_law.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// So many meshes at most have all senses of their losses tried, two for each: 4096.
inline constexpr int kMostSearchedMeshes = 12;

/// Which gear of each mesh drives decides the sense of its loss, and follows from the actions that
/// the losses change.
enum class LossSearch {
  found,     ///< senses that agree with the actions they cause, which were accepted
  rejected,  ///< all senses that agree with their actions were rejected; one of them is given
  none,      ///< no senses agree with their actions, or friction locks
  no_share,  ///< a loss that depends on speed or force has no value there, or none from 0 to 1
  undecided  ///< there are too many meshes to try all senses, and the likely ones failed
};

/// The couples of the losses are frictions of the solution `between` a carrier and a driven gear,
/// after those of the couplings. Its status is `locked`, and it has no actions, where the search
/// found none to give.
struct LossyActions {
  LossSearch search = LossSearch::found;
  StaticSolution solution;
  std::optional<StaticSolution> other;  ///< of other senses that agree with their actions and were
                                        ///< accepted too, and whose actions differ: large losses
                                        ///< may have several answers
};

/// What acts in a case: known actions, loads, and the laws of what is lost.
struct LossyStatics {
  std::span<const Primary> primaries;
  std::span<const BodyWrench> loads;
  std::span<const FrictionLaw> frictions;  ///< of the couplings
  std::span<const MeshLossLaw> meshes;
};

/// The coordinates that hold the actions of a mechanism, the loads and all laws.
CoordinateBasis lossy_action_basis(const Mechanism& mechanism, const LossyStatics& given);

/// The senses begin as without losses and are turned where a power contradicts them, until none
/// does; where that goes in circles, or what it finds is not accepted, all are tried, those that
/// turn the fewest meshes first (at most kMostSearchedMeshes meshes). With the senses the losses
/// are linear and solved at once; friction of couplings is followed as in solve_with_friction.
/// Losses so large that they may have several answers are searched for another.
/// `is_accepted` is given the magnitudes of all actions. `basis` must hold the wrenches of all
/// laws.
[[nodiscard]] LossyActions solve_with_losses(const Mechanism& mechanism,
                                             const CoordinateBasis& basis,
                                             const LossyStatics& given,
                                             const std::function<bool(const VecX&)>& is_accepted);

}  // namespace kinestat
