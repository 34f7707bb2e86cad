#include "statics/friction.hpp"

#include "statics/action.hpp"
#include "statics/internal/friction_function.hpp"
#include "statics/internal/friction_system.hpp"

namespace kinestat {

StaticSolution solve_with_friction(const Mechanism& mechanism,
                                   const CoordinateBasis& basis,
                                   std::span<const Primary> primaries,
                                   std::span<const BodyWrench> loads,
                                   std::span<const FrictionLaw> laws) {
  StaticSolution frictionless = solve_action(mechanism, basis, primaries, loads);
  const bool has_answer = frictionless.status == SolveStatus::solved ||
                          frictionless.status == SolveStatus::underdetermined;
  if (laws.empty() || !has_answer) {
    return frictionless;
  }
  FrictionSystem system(mechanism, basis, primaries, loads, laws);
  system.find_open(frictionless.check.undetermined);
  ChosenFrictions chosen;
  for (std::size_t i = 0; i < laws.size(); ++i) {
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

}  // namespace kinestat
