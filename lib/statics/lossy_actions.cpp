#include "statics/lossy_actions.hpp"

#include <algorithm>
#include <utility>

#include "network/bases.hpp"
#include "statics/action.hpp"
#include "statics/lossy_system.hpp"

namespace kinestat {

CoordinateBasis lossy_action_basis(const Mechanism& mechanism, const LossyStatics& given) {
  std::vector<BodyWrench> outside(given.loads.begin(), given.loads.end());
  const auto add = [&](const FrictionLaw& law) {
    const BodyId head =
        law.between ? law.between->head : mechanism.topology.coupling(law.coupling).head;
    outside.push_back({.body = head, .wrench = law.unit});
  };
  std::ranges::for_each(given.frictions, add);
  for (const MeshLossLaw& mesh : given.meshes) {
    add(mesh.head_driven);
    add(mesh.tail_driven);
  }
  return action_basis(mechanism.geometry, mechanism.static_order, outside);
}

LossyActions solve_with_losses(const Mechanism& mechanism,
                               const CoordinateBasis& basis,
                               const LossyStatics& given,
                               const std::function<bool(const VecX&)>& is_accepted) {
  StaticSolution frictionless = solve_action(mechanism, basis, given.primaries, given.loads);
  if (frictionless.status != SolveStatus::solved &&
      frictionless.status != SolveStatus::underdetermined) {
    return {.search = LossSearch::none, .solution = std::move(frictionless), .other = {}};
  }
  LossyActions result = LossySystem(mechanism, basis, given, frictionless).solve_whole(is_accepted);
  if (result.solution.magnitudes.empty()) {
    frictionless.status = result.solution.status;
    frictionless.magnitudes.clear();
    frictionless.wrenches.clear();
    result.solution = std::move(frictionless);
  }
  return result;
}

}  // namespace kinestat
