// Actions in a mechanism whose meshes lose power, and whose couplings may have friction.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "statics/mesh_loss_law.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// With up to this many meshes, all combinations of the senses of their losses are tried: 4096.
inline constexpr int kMostSearchedMeshes = 12;

/// The result of the search for the senses of the losses. The sense depends on which gear of a mesh
/// drives; this depends on the actions, which the losses change.
enum class LossSearch {
  found,     ///< senses that agree with the actions they cause; the caller accepted these actions
  rejected,  ///< the caller rejected the actions of all such senses; one of them is returned
  none,      ///< no senses agree with the actions they cause, or friction locks
  no_share,  ///< a loss that depends on speed or force has no value, or one outside 0 to 1
  undecided  ///< there are too many meshes to try all senses, and the likely ones failed
};

/// The couples of the losses are listed in the friction of the solution, after that of the
/// couplings; each acts `between` a carrier and a driven gear. If the search found no actions, the
/// status is `locked`.
struct LossyActions {
  LossSearch search = LossSearch::found;
  StaticSolution solution;
  std::optional<StaticSolution> other;  ///< a second solution, with other senses and actions, that
                                        ///< was accepted too: large losses may have several
};

/// The known actions, the loads, and the laws of friction and losses of a case.
struct LossyStatics {
  std::span<const Primary> primaries;
  std::span<const BodyWrench> loads;
  std::span<const FrictionLaw> frictions;  ///< of the couplings
  std::span<const MeshLossLaw> meshes;
};

/// A basis that holds the actions of the mechanism, the loads, and the wrenches of all laws.
CoordinateBasis lossy_action_basis(const Mechanism& mechanism, const LossyStatics& given);

/// Solves for the actions with the losses of meshes. The senses of the losses begin as without
/// losses, and are reversed as long as a power contradicts them. If this does not end, or its
/// result is not accepted, all combinations are tried, those that reverse the fewest meshes first
/// (with at most kMostSearchedMeshes meshes). With given senses the losses are linear and are
/// solved at once; the friction of couplings is followed as in solve_with_friction. If the losses
/// are so large that there may be several answers, a second one is looked for. `is_accepted`
/// receives the magnitudes of all actions [N·m or N]. `basis` must hold the wrenches of all laws.
[[nodiscard]] LossyActions solve_with_losses(const Mechanism& mechanism,
                                             const CoordinateBasis& basis,
                                             const LossyStatics& given,
                                             const std::function<bool(const VecX&)>& is_accepted);

}  // namespace kinestat
