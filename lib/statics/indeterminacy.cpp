#include "statics/indeterminacy.hpp"

#include <utility>
#include <vector>

#include "core/tolerance.hpp"
#include "math/least_squares.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/equilibrium.hpp"

namespace kinestat {

namespace {

// Of each action: 1 for a force, the mechanism's length for a couple.
VecX scales_of(const Mechanism& mechanism) {
  VecX scales(mechanism.topology.action_count());
  for (Eigen::Index a = 0; a < scales.size(); ++a) {
    const bool is_couple = mechanism.topology.actions[static_cast<std::size_t>(a)].is_couple;
    scales[a] = is_couple ? mechanism.geometry.length : 1.0;
  }
  return scales;
}

// What least squares weigh the magnitudes in their scales with: 1, or for elastic actions what
// makes the sum of squares twice the complementary energy.
VecX weights_of(const Mechanism& mechanism, const VecX& scales) {
  if (mechanism.indeterminate == IndeterminateChoice::minimum_norm) {
    return VecX::Ones(scales.size());
  }
  const Eigen::Map<const VecX> compliances(mechanism.compliances.data(), scales.size());
  return compliances.cwiseSqrt().cwiseProduct(scales);
}

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

// The self-stresses in columns, in their scales, the largest entry 1 and what is rounding beside it
// zero.
MatX scaled_columns(const std::vector<VecX>& stresses, const VecX& scales) {
  MatX columns(scales.size(), static_cast<Eigen::Index>(stresses.size()));
  for (std::size_t j = 0; j < stresses.size(); ++j) {
    const VecX scaled = stresses[j].cwiseQuotient(scales);
    const double largest = scaled.cwiseAbs().maxCoeff();
    columns.col(static_cast<Eigen::Index>(j)) =
        (scaled.array().abs() <= kRankZero * largest).select(0.0, scaled / largest);
  }
  return columns;
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
  const VecX scales = scales_of(mechanism);
  const VecX particular = equilibrium.solve(known.actions, known.loads).magnitudes;
  const LeastSquares least = find_least_squares(scaled_columns(stresses, scales),
                                                particular.cwiseQuotient(scales),
                                                weights_of(mechanism, scales));
  const VecX magnitudes = least.values.cwiseProduct(scales);
  solution.completion.by = mechanism.indeterminate;
  solution.completion.length = mechanism.geometry.length;
  for (const int a : solution.check.undetermined) {
    if (!least.is_open[static_cast<std::size_t>(a)]) {
      solution.magnitudes[static_cast<std::size_t>(a)] = magnitudes[a];
      solution.completion.actions.push_back(a);
    }
  }
  const bool is_whole = solution.completion.actions.size() == solution.check.undetermined.size();
  if (is_whole && mechanism.indeterminate == IndeterminateChoice::stiffness) {
    solution.status = SolveStatus::solved;
  }
  solution.residual = equilibrium.residual(magnitudes, known.loads);
  solution.wrenches = coupling_wrenches(mechanism, solution);
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
  const Equilibrium equilibrium(mechanism, basis, std::move(indices));
  const std::vector<BodyWrench> all = with_friction(mechanism, loads, solution);
  const std::vector<VecX> stresses = equilibrium.self_stresses();
  solution.self_stresses = list_self_stresses(stresses, scales_of(mechanism));
  if (mechanism.indeterminate == IndeterminateChoice::report || !is_friction_known(solution)) {
    return solution;
  }
  return completed(
      mechanism, equilibrium, {.actions = known, .loads = all}, stresses, std::move(solution));
}

StaticSolution without_completion(const Mechanism& mechanism, StaticSolution solution) {
  if (solution.completion.actions.empty()) {
    return solution;
  }
  for (const int a : solution.completion.actions) {
    solution.magnitudes[static_cast<std::size_t>(a)].reset();
  }
  solution.completion = {};
  solution.status = SolveStatus::underdetermined;
  solution.wrenches = coupling_wrenches(mechanism, solution);
  return solution;
}

}  // namespace kinestat
