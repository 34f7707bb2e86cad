#include "statics/exact_input_action.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/elimination/bounded_solve.hpp"
#include "network/exact_input_system.hpp"
#include "network/node_system.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

// The same actions are open, as many as the doubles say, or none.
bool agrees(const ExactInputElimination& elimination, const StaticSolution& rounded) {
  const std::vector<int>& open = elimination.free_columns();
  const std::vector<int>& undetermined = rounded.check.undetermined;
  return elimination.relation_count() == 0 &&
         (open.empty() || (rounded.status == SolveStatus::underdetermined &&
                           static_cast<int>(open.size()) == rounded.check.missing &&
                           std::ranges::all_of(open, [&](int a) {
                             return std::ranges::binary_search(undetermined, a);
                           })));
}

void fill(const Mechanism& mechanism,
          const CoordinateBasis& basis,
          const ExactInputSolution& solved,
          double largest_load,
          StaticSolution& solution) {
  const int count = mechanism.topology.action_count();
  std::vector<bool> counts(static_cast<std::size_t>(count), true);
  solution.magnitudes.assign(counts.size(), std::nullopt);
  for (int a = 0; a < count; ++a) {
    const double unit = action_unit(mechanism.topology, basis, a);
    const auto i = static_cast<std::size_t>(a);
    solution.answer.bounds.push_back(unit * solved.bound[a]);
    counts[i] = !std::ranges::binary_search(solution.check.undetermined, a);
    if (counts[i]) {
      solution.magnitudes[i] = unit * solved.x[a];
    }
  }
  solution.answer.error_bound = worst_relative_error(solved.x, solved.bound, counts, largest_load);
  make_wrenches(mechanism, solution);
}

}  // namespace

std::optional<StaticSolution> solve_action_of_exact_input(
    const Mechanism& mechanism,
    const std::vector<ExactInputScrew>& actions,
    const Case& which,
    const ExactInputCase& exact_input,
    const StaticSolution& rounded) {
  const Topology& topology = mechanism.topology;
  const CoordinateBasis basis = spatial_basis(ScrewKind::wrench, mechanism.geometry.length);
  ExactInputMatrix system = exact_input_action_system(topology, actions, basis);
  if (!has_digits(system)) {
    return std::nullopt;
  }
  std::vector<int> columns;
  std::vector<ExactInput> known;
  for (std::size_t i = 0; i < which.actions.size(); ++i) {
    columns.push_back(which.actions[i].index);
    known.push_back(exact_input.actions[i] /
                    ExactInput(action_unit(topology, basis, columns.back())));
  }
  const ExactInputElimination elimination(std::move(system), columns);
  const auto right =
      exact_input_load_vector(topology.body_count(), basis, which.loads, exact_input.loads);
  const auto solved = agrees(elimination, rounded) ? elimination.solve(known, right) : std::nullopt;
  if (!solved || !solved->x.allFinite()) {
    return std::nullopt;
  }
  StaticSolution solution;
  solution.counts = rounded.counts;
  solution.evidence = rounded.evidence;
  if (!solved->consistent) {
    solution.status = SolveStatus::inconsistent;
    return rounded.status == SolveStatus::solved ? std::optional(std::move(solution))
                                                 : std::nullopt;
  }
  const bool is_open = !elimination.free_columns().empty();
  solution.status = is_open ? SolveStatus::underdetermined : SolveStatus::solved;
  if (is_open) {
    solution.check = rounded.check;
  }
  solution.answer = {.precision = Precision::exact,
                     .error_bound = {},
                     .bounds = {},
                     .is_exact_input = true,
                     .is_exact = solved->is_exact};
  double largest_load = 0.0;
  for (const ExactInput& one : right) {
    largest_load = std::max(largest_load, std::abs(one.value));
  }
  fill(mechanism, basis, *solved, largest_load, solution);
  return solution;
}

}  // namespace kinestat
