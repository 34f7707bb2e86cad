#include "statics/friction.hpp"

#include <algorithm>
#include <utility>

#include "statics/action.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/internal/friction_function.hpp"
#include "statics/internal/friction_system.hpp"

namespace kinestat {

namespace {

// What acts in a case.
struct FrictionLoads {
  std::span<const Primary> primaries;
  std::span<const BodyWrench> loads;
  std::span<const FrictionLaw> laws;
};

bool has_answer(const StaticSolution& solution) {
  return solution.status == SolveStatus::solved || solution.status == SolveStatus::underdetermined;
}

// The equilibrium that grows out of the one without friction, which must have an answer.
StaticSolution follow(const Mechanism& mechanism,
                      const CoordinateBasis& basis,
                      const FrictionLoads& given,
                      StaticSolution frictionless) {
  FrictionSystem system(mechanism, basis, given.primaries, given.loads, given.laws);
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
    frictionless.status = SolveStatus::locked;
    frictionless.magnitudes.clear();
    frictionless.wrenches.clear();
    return frictionless;
  }
  chosen.magnitudes = *f;
  return system.solution_with(chosen);
}

StaticSolution solve_from_frictionless(const Mechanism& mechanism,
                                       const CoordinateBasis& basis,
                                       const FrictionLoads& given) {
  StaticSolution frictionless = solve_action(mechanism, basis, given.primaries, given.loads);
  if (given.laws.empty() || !has_answer(frictionless)) {
    return frictionless;
  }
  return follow(mechanism, basis, given, std::move(frictionless));
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

}  // namespace kinestat
