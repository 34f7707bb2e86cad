#include "statics/friction_solve.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "statics/action.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/internal/friction_function.hpp"
#include "statics/internal/friction_hold.hpp"
#include "statics/internal/friction_loads.hpp"
#include "statics/internal/friction_system.hpp"
#include "statics/internal/tied_tensions.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

namespace {

bool has_answer(const StaticSolution& solution) {
  return solution.status == SolveStatus::solved || solution.status == SolveStatus::underdetermined;
}

// The equilibrium that grows out of the one without friction, which must have an answer.
StaticSolution follow(const Mechanism& mechanism,
                      const CoordinateBasis& basis,
                      const FrictionLoads& given,
                      const std::vector<TiedTension>& ties,
                      StaticSolution frictionless) {
  FrictionSystem system(mechanism, basis, given.primaries, given.loads, given.laws, ties);
  system.find_open(frictionless.check.undetermined);
  ChosenFrictions chosen;
  for (std::size_t i = 0; i < given.laws.size(); ++i) {
    if (!system.is_open(i)) {
      chosen.laws.push_back(i);
    }
  }
  std::vector<FrictionFunction> functions;
  for (const std::size_t i : chosen.laws) {
    functions.push_back(system.function_of(i, chosen.laws));
  }
  const std::optional<VecX> f = follow_friction(functions);
  if (!f) {
    frictionless.status = SolveStatus::locked_by_friction;
    frictionless.magnitudes.clear();
    frictionless.wrenches.clear();
    return frictionless;
  }
  chosen.magnitudes = *f;
  StaticSolution solution = system.solution_with(chosen);
  if (const std::optional<VecX> other = find_other_friction(functions, *f)) {
    const VecX actions = system.actions_with({.laws = chosen.laws, .magnitudes = *other});
    if (is_one_sided(actions, mechanism.topology)) {
      solution.other_actions.push_back(actions);
    }
  }
  return solution;
}

double drag_of(const PressingPart& cable,
               const Topology& topology,
               const StaticSolution& solution) {
  return cable.weight *
         bounded_action(solution, topology.coupling(*cable.of).first_action).zeroed();
}

// Where cables slip, the tension behind a pulley is a share of that ahead: as an equation, for as
// the difference of that tension and the friction it would be lost in rounding. Empty where no
// cables slip, or that has no answer in which they pull.
std::optional<StaticSolution> solve_tied(const Mechanism& mechanism,
                                         const CoordinateBasis& basis,
                                         const FrictionLoads& given,
                                         TiedTo to) {
  const std::vector<TiedTension> ties = find_ties(mechanism, given.primaries, given.laws, to);
  if (ties.empty()) {
    return std::nullopt;
  }
  std::vector<FrictionLaw> rest(given.laws.begin(), given.laws.end());
  for (FrictionLaw& law : rest) {
    if (is_tied(mechanism, given.primaries, law)) {
      law.parts.clear();
    }
  }
  StaticSolution solution = solve_action(mechanism, basis, given.primaries, given.loads, {}, ties);
  if (solution.status == SolveStatus::solved) {
    solution = follow(mechanism,
                      basis,
                      {.primaries = given.primaries, .loads = given.loads, .laws = rest},
                      ties,
                      std::move(solution));
  }
  if (solution.status == SolveStatus::overflow) {
    return solution;
  }
  if (solution.status != SolveStatus::solved || solution.friction.size() != given.laws.size()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < given.laws.size(); ++i) {
    const FrictionLaw& law = given.laws[i];
    FrictionAction& friction = solution.friction[i];
    if (is_tied(mechanism, given.primaries, law)) {
      friction.magnitude = drag_of(law.parts.front(), mechanism.topology, solution);
      if (friction.magnitude < 0.0) {
        return std::nullopt;
      }
      friction.wrench = friction.magnitude * law.unit;
    }
  }
  make_wrenches(mechanism, solution);
  return solution;
}

StaticSolution solve_from_frictionless(const Mechanism& mechanism,
                                       const CoordinateBasis& basis,
                                       const FrictionLoads& given) {
  for (const TiedTo to : {TiedTo::least, TiedTo::greatest}) {
    if (std::optional<StaticSolution> tied = solve_tied(mechanism, basis, given, to)) {
      return std::move(*tied);
    }
  }
  StaticSolution frictionless = solve_action(mechanism, basis, given.primaries, given.loads);
  if (given.laws.empty() || frictionless.status == SolveStatus::overflow) {
    return frictionless;
  }
  if (frictionless.status == SolveStatus::inconsistent) {
    frictionless.other_actions = find_held_by_friction(mechanism, basis, given, frictionless);
  }
  if (!has_answer(frictionless)) {
    return frictionless;
  }
  return follow(mechanism, basis, given, {}, std::move(frictionless));
}

// Whether surfaces pull on each other that can only push, beyond rounding.
bool has_pull(const StaticSolution& solution, std::span<const FrictionLaw> laws) {
  return std::ranges::any_of(laws, [&](const FrictionLaw& law) {
    return law.pushed_by &&
           solution.magnitudes[static_cast<std::size_t>(*law.pushed_by)].has_value() &&
           bounded_action(solution, *law.pushed_by).zeroed() < 0.0;
  });
}

// Whether the action that presses is known and does, or the surfaces do not touch.
bool pushes(const StaticSolution& solution, const FrictionLaw& law) {
  return solution.magnitudes[static_cast<std::size_t>(*law.pushed_by)].has_value() &&
         bounded_action(solution, *law.pushed_by).zeroed() >= 0.0;
}

bool all_push(const StaticSolution& solution, std::span<const FrictionLaw> laws) {
  return has_answer(solution) && std::ranges::all_of(laws, [&](const FrictionLaw& law) {
           return !law.pushed_by || pushes(solution, law);
         });
}

FrictionAction friction_of(const FrictionLaw& law, double magnitude) {
  return {.coupling = law.coupling,
          .between = law.between,
          .magnitude = magnitude,
          .is_couple = law.is_couple,
          .wrench = magnitude * law.unit};
}

// Surfaces that push press on each other along the normal, leant over by the angle of friction:
// there equilibrium is linear, and has an answer also where nothing but friction holds the motion.
// The mechanism with these normals answers for the others.
StaticSolution solve_pushing(const Mechanism& mechanism,
                             const CoordinateBasis& basis,
                             const FrictionLoads& given) {
  Mechanism leaning = mechanism;
  std::vector<FrictionLaw> others;
  for (const FrictionLaw& law : given.laws) {
    if (!law.pushed_by) {
      others.push_back(law);
      continue;
    }
    Wrench& action = leaning.geometry.actions[static_cast<std::size_t>(*law.pushed_by)];
    action = action + law.parts.front().weight * law.unit;
  }
  StaticSolution solution = solve_from_frictionless(
      leaning, basis, {.primaries = given.primaries, .loads = given.loads, .laws = others});
  if (!all_push(solution, given.laws)) {
    return solution;
  }
  std::vector<FrictionAction> rest = std::exchange(solution.friction, {});
  auto next = rest.begin();
  for (const FrictionLaw& law : given.laws) {
    if (law.pushed_by) {
      const double force = bounded_action(solution, *law.pushed_by).zeroed();
      solution.friction.push_back(friction_of(law, law.parts.front().weight * force));
    } else if (next != rest.end() && next->coupling == law.coupling) {
      solution.friction.push_back(std::move(*next++));
    }
  }
  make_wrenches(mechanism, solution);
  return solution;
}

}  // namespace

StaticSolution solve_with_friction(const Mechanism& mechanism,
                                   const CoordinateBasis& basis,
                                   std::span<const Primary> primaries,
                                   std::span<const BodyWrench> loads,
                                   std::span<const FrictionLaw> laws) {
  const FrictionLoads given{.primaries = primaries, .loads = loads, .laws = laws};
  StaticSolution solution = solve_from_frictionless(mechanism, basis, given);
  const bool has_surfaces =
      std::ranges::any_of(laws, [](const FrictionLaw& law) { return law.pushed_by.has_value(); });
  const bool is_possible = has_answer(solution) && !has_pull(solution, laws);
  if (!has_surfaces || is_possible || solution.status == SolveStatus::overflow) {
    return solution;
  }
  StaticSolution pushing = solve_pushing(mechanism, basis, given);
  return all_push(pushing, laws) ? pushing : solution;
}

FrictionMagnitudes solve_friction_balance(const FrictionBalance& given) {
  FrictionSystem system(
      given.mechanism, given.basis, given.primaries, given.loads, given.laws, {}, given.along);
  system.find_open(system.undetermined());
  std::vector<std::size_t> all(given.laws.size());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<FrictionFunction> functions;
  for (const std::size_t i : all) {
    if (system.is_open(i)) {
      return {.outcome = FrictionOutcome::open, .values = {}, .open = given.laws[i].coupling};
    }
    functions.push_back(system.function_of(i, all));
  }
  const std::optional<VecX> found = follow_friction(functions);
  if (!found) {
    return {.outcome = FrictionOutcome::none, .values = {}};
  }
  if (find_other_friction(functions, *found)) {
    return {.outcome = FrictionOutcome::several, .values = {}};
  }
  return {.outcome = FrictionOutcome::solved, .values = *found};
}

}  // namespace kinestat
