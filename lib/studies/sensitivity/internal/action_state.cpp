#include "studies/sensitivity/internal/action_state.hpp"

#include <iterator>

#include "statics/completed_actions.hpp"

namespace kinestat {

namespace {

// Empty if one of them is open.
std::vector<double> known_magnitudes(const StaticSolution& action) {
  std::vector<double> result;
  for (const std::optional<double>& magnitude : action.magnitudes) {
    if (!magnitude) {
      return {};
    }
    result.push_back(*magnitude);
  }
  return result;
}

VecX vector_of(const std::vector<double>& list) {
  return Eigen::Map<const VecX>(list.data(), std::ssize(list));
}

void complete(const Mechanism& mechanism, ActionState& state) {
  std::vector<VecX> stresses;
  for (const std::vector<double>& stress : state.stresses) {
    stresses.push_back(vector_of(stress));
  }
  const CompletedActions found =
      find_completed_actions(mechanism, vector_of(state.magnitudes), stresses);
  state.magnitudes.assign(found.magnitudes.begin(), found.magnitudes.end());
  state.completed_count = static_cast<std::size_t>(found.measured.cols());
  state.stresses.clear();
  for (const MatX* columns : {&found.measured, &found.open}) {
    for (Eigen::Index c = 0; c < columns->cols(); ++c) {
      const VecX stress = columns->col(c);
      state.stresses.emplace_back(stress.begin(), stress.end());
    }
  }
}

}  // namespace

ActionState find_action_state(const DualCase& values, const FactoredSide& equations) {
  ActionState state{.magnitudes = known_magnitudes(*values.action()),
                    .stresses = equations.open_magnitudes(),
                    .completed_count = 0};
  if (state.magnitudes.empty()) {
    state.magnitudes = equations.solve(known_actions(values, equations.basis()));
  }
  if (values.action()->completion.by != IndeterminateChoice::report) {
    complete(values.mechanism(), state);
  }
  return state;
}

}  // namespace kinestat
