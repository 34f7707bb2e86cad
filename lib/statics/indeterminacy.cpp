#include "statics/indeterminacy.hpp"

#include <utility>
#include <vector>

#include "math/dense/readable_basis.hpp"
#include "statics/completed_actions.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/equilibrium.hpp"

namespace kinestat {

namespace {

// Friction as loads on both bodies of its coupling, beside those from outside.
std::vector<BodyWrench> with_friction(const Mechanism& mechanism,
                                      std::span<const BodyWrench> loads,
                                      const StaticSolution& solution) {
  std::vector<BodyWrench> all(loads.begin(), loads.end());
  for (const FrictionAction& friction : solution.friction) {
    const CouplingTopology& coupling = mechanism.topology.coupling(friction.coupling);
    all.push_back({.body = coupling.head, .wrench = friction.wrench});
    all.push_back({.body = coupling.tail, .wrench = -1.0 * friction.wrench});
  }
  return all;
}

// Friction that could not be found may depend on the actions that are open.
bool is_friction_known(const StaticSolution& solution) {
  return solution.open_friction.empty();
}

// What the equilibrium of a case knows.
struct Known {
  std::span<const double> actions;  // of the primaries
  std::span<const BodyWrench> loads;
};

StaticSolution completed(const Mechanism& mechanism,
                         const Equilibrium& equilibrium,
                         const Known& known,
                         const std::vector<VecX>& stresses,
                         StaticSolution solution) {
  const CompletedActions found = find_completed_actions(
      mechanism, equilibrium.solve(known.actions, known.loads).magnitudes, stresses);
  solution.answer = {};
  solution.completion.by = mechanism.indeterminate;
  solution.completion.length = mechanism.geometry.length;
  for (const int a : solution.check.undetermined) {
    if (!found.is_open[static_cast<std::size_t>(a)]) {
      solution.magnitudes[static_cast<std::size_t>(a)] = found.magnitudes[a];
      solution.completion.actions.push_back(a);
    }
  }
  const bool is_whole = solution.completion.actions.size() == solution.check.undetermined.size();
  if (is_whole && mechanism.indeterminate == IndeterminateChoice::stiffness) {
    solution.status = SolveStatus::solved;
  }
  solution.residual = equilibrium.residual(found.magnitudes, known.loads);
  make_wrenches(mechanism, solution);
  return solution;
}

}  // namespace

StaticSolution resolve_indeterminacy(const Mechanism& mechanism,
                                     const CoordinateBasis& basis,
                                     std::span<const Primary> primaries,
                                     std::span<const BodyWrench> loads,
                                     StaticSolution solution) {
  if (solution.status != SolveStatus::underdetermined || solution.magnitudes.empty()) {
    return solution;
  }
  std::vector<int> indices;
  std::vector<double> known;
  for (const Primary& primary : primaries) {
    indices.push_back(primary.index);
    known.push_back(primary.value);
  }
  const bool is_report_alone =
      mechanism.indeterminate == IndeterminateChoice::report || !is_friction_known(solution);
  const auto missing = static_cast<std::size_t>(solution.check.missing);
  if (is_report_alone && missing * mechanism.topology.actions.size() > kLongestList) {
    return solution;
  }
  const Equilibrium equilibrium(mechanism, basis, std::move(indices));
  const std::vector<BodyWrench> all = with_friction(mechanism, loads, solution);
  const std::vector<VecX> stresses = equilibrium.self_stresses();
  solution.self_stresses = list_self_stresses(stresses, action_scales(mechanism));
  if (is_report_alone) {
    return solution;
  }
  return completed(
      mechanism, equilibrium, {.actions = known, .loads = all}, stresses, std::move(solution));
}

}  // namespace kinestat
