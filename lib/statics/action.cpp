#include "statics/action.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "mechanism/position_error.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/equilibrium.hpp"

namespace kinestat {

namespace {

// Whether the primaries violate a relation that equilibrium demands of them.
bool is_violated(const Dependence& dependence, std::span<const Primary> primaries) {
  double sum = -dependence.constant;
  double size = dependence.constant_size;
  for (const DependenceTerm& term : dependence.terms) {
    const auto primary = std::ranges::find(primaries, term.index, &Primary::index);
    const double part = primary == primaries.end() ? 0.0 : term.coefficient * primary->value;
    sum += part;
    size += std::abs(part);
  }
  return std::abs(sum) > kConsistency * size;
}

void fill_magnitudes(const VecX& magnitudes, StaticSolution& solution) {
  solution.magnitudes.resize(static_cast<std::size_t>(magnitudes.size()));
  for (int a = 0; a < magnitudes.size(); ++a) {
    if (!std::ranges::binary_search(solution.check.undetermined, a)) {
      solution.magnitudes[static_cast<std::size_t>(a)] = magnitudes[a];
    }
  }
}

std::vector<bool> determined_actions(const Mechanism& mechanism, const PrimaryCheck& check) {
  std::vector<bool> result(mechanism.topology.actions.size(), true);
  for (const int a : check.undetermined) {
    result[static_cast<std::size_t>(a)] = false;
  }
  return result;
}

// Whether no number is too large, or none at all.
bool is_in_range(const StaticSolution& solution) {
  const auto holds = [](double x) { return std::abs(x) <= kLargestMagnitude; };
  return std::ranges::all_of(
             solution.magnitudes,
             [&](const std::optional<double>& m) { return holds(m.value_or(0.0)); }) &&
         std::ranges::all_of(solution.wrenches, [&](const std::optional<Wrench>& wrench) {
           return std::ranges::all_of(wrench.value_or(Wrench{}).coordinates(), holds);
         });
}

}  // namespace

StaticSolution solve_action(const Mechanism& mechanism,
                            const CoordinateBasis& basis,
                            std::span<const Primary> primaries,
                            std::span<const BodyWrench> loads,
                            const AccuracyRequest& request,
                            const std::vector<TiedTension>& ties) {
  std::vector<int> indices;
  std::vector<double> known;
  indices.reserve(primaries.size());
  known.reserve(primaries.size());
  for (const Primary& primary : primaries) {
    indices.push_back(primary.index);
    known.push_back(primary.value);
  }
  const Equilibrium equilibrium(mechanism, basis, std::move(indices), ties);
  StaticSolution solution;
  solution.evidence = equilibrium.evidence();
  solution.counts = equilibrium.counts();
  solution.check = equilibrium.check(loads);
  EquilibriumActions actions =
      equilibrium.solve_to(request, determined_actions(mechanism, solution.check), known, loads);
  if (!actions.consistent) {
    solution.status = SolveStatus::inconsistent;
    solution.unconstrained = find_unconstrained_motion(mechanism, basis, primaries, loads);
    std::erase_if(solution.check.dependences,
                  [&](const Dependence& one) { return !is_violated(one, primaries); });
    return solution;
  }
  if (!solution.check.dependences.empty()) {
    solution.status = SolveStatus::dependent;
    return solution;
  }
  solution.status = solution.check.missing > 0 ? SolveStatus::underdetermined : SolveStatus::solved;
  solution.residual = actions.residual;
  solution.answer = actions.answer;
  if (position_error(mechanism) > 0.0) {
    equilibrium.settle(mechanism, loads, actions.magnitudes);
  }
  fill_magnitudes(actions.magnitudes, solution);
  make_wrenches(mechanism, solution);
  if (!is_in_range(solution)) {
    solution.status = SolveStatus::overflow;
    solution.magnitudes.clear();
    solution.wrenches.clear();
  }
  return solution;
}

}  // namespace kinestat
