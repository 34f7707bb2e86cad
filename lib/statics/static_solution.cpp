#include "statics/static_solution.hpp"

#include <algorithm>

namespace kinestat {

bool is_completed(const StaticSolution& solution, int action) {
  return std::ranges::binary_search(solution.completion.actions, action);
}

bool is_completed(const StaticSolution& solution, const CouplingTopology& coupling) {
  const auto& actions = solution.completion.actions;
  const auto at = std::ranges::lower_bound(actions, coupling.first_action);
  return at != actions.end() && *at < coupling.first_action + coupling.action_count;
}

bool is_by_convention(const StaticSolution& solution, int action) {
  return solution.completion.by == IndeterminateChoice::minimum_norm &&
         is_completed(solution, action);
}

bool is_by_convention(const StaticSolution& solution, const CouplingTopology& coupling) {
  return solution.completion.by == IndeterminateChoice::minimum_norm &&
         is_completed(solution, coupling);
}

}  // namespace kinestat
