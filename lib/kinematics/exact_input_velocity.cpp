#include "kinematics/exact_input_velocity.hpp"

#include <algorithm>

#include "kinematics/bounded_motion.hpp"
#include "math/elimination/bounded_solve.hpp"
#include "network/exact_input_system.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// A rate may be open, unlike a twist, which follows from them.
bool determines_all(const ExactInputElimination& elimination) {
  return elimination.free_columns().empty() && elimination.relation_count() == 0;
}

void fill(const Mechanism& mechanism,
          const CoordinateBasis& basis,
          const ExactInputSolution& solved,
          KinematicSolution& solution) {
  const Topology& topology = mechanism.topology;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    const double unit = rate_unit(topology, basis, f);
    const int column = velocity_column(topology, basis, f);
    solution.rates.push_back(unit * solved.x[column]);
    solution.answer.bounds.push_back(unit * solved.bound[column]);
  }
  for (int b = 0; b < topology.body_count(); ++b) {
    solution.bodies.push_back(body_twist(solved.x, basis, BodyId{b}));
    solution.body_bounds.push_back(body_twist(solved.bound, basis, BodyId{b}));
    solution.bodies.back() = bounded_body(solution, BodyId{b}).zeroed();
  }
  for (int e = 0; e < topology.coupling_count(); ++e) {
    solution.couplings.push_back(bounded_coupling(mechanism, solution, CouplingId{e}).zeroed());
  }
}

}  // namespace

std::optional<KinematicSolution> solve_velocity_of_exact_input(
    const Mechanism& mechanism,
    const std::vector<ExactInputScrew>& motions,
    std::span<const Primary> primaries,
    std::span<const ExactInput> values,
    const KinematicSolution& rounded) {
  const Topology& topology = mechanism.topology;
  const CoordinateBasis basis = spatial_basis(ScrewKind::twist, mechanism.geometry.length);
  ExactInputMatrix system = exact_input_velocity_system(topology, motions, basis);
  if (!has_digits(system)) {
    return std::nullopt;
  }
  std::vector<int> columns;
  std::vector<ExactInput> known;
  for (std::size_t i = 0; i < primaries.size(); ++i) {
    columns.push_back(velocity_column(topology, basis, primaries[i].index));
    known.push_back(values[i] / ExactInput(rate_unit(topology, basis, primaries[i].index)));
  }
  const ExactInputElimination elimination(std::move(system), columns);
  const auto solved = determines_all(elimination) ? elimination.solve(known, {}) : std::nullopt;
  if (!solved || !solved->x.allFinite()) {
    return std::nullopt;
  }
  KinematicSolution solution{.status = SolveStatus::solved,
                             .counts = rounded.counts,
                             .evidence = rounded.evidence,
                             .residual = 0.0,
                             .answer = {.precision = Precision::exact,
                                        .error_bound = {},
                                        .bounds = {},
                                        .is_exact_input = true,
                                        .is_exact = solved->is_exact},
                             .check = {},
                             .rates = {},
                             .bodies = {},
                             .body_bounds = {},
                             .couplings = {}};
  const std::vector<bool> counts(static_cast<std::size_t>(solved->x.size()), true);
  solution.answer.error_bound = worst_relative_error(solved->x, solved->bound, counts, 0.0);
  fill(mechanism, basis, *solved, solution);
  return solution;
}

}  // namespace kinestat
