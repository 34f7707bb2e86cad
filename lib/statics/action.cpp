#include "statics/action.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// Whether the primaries violate one of the relations that equilibrium demands of them.
bool contradicts(const PrimaryCheck& check, std::span<const Primary> primaries) {
  return std::ranges::any_of(check.dependences, [&](const auto& terms) {
    double sum = 0.0;
    double size = 0.0;
    for (const DependenceTerm& term : terms) {
      const auto primary = std::ranges::find(primaries, term.index, &Primary::index);
      const double part = primary == primaries.end() ? 0.0 : term.coefficient * primary->value;
      sum += part;
      size += std::abs(part);
    }
    return std::abs(sum) > kConsistency * size;
  });
}

// A virtual motion reciprocal to every secondary action but not to the primaries: the solution of
// the transposed system. Empty if rounding hides it.
std::optional<UnheldMotion> find_unheld(const SparseMatrix& system,
                                        const CoordinateBasis& basis,
                                        std::span<const Primary> primaries) {
  SparseMatrix transposed{.rows = system.columns, .columns = system.rows, .entries = {}};
  VecX load = VecX::Zero(system.rows);
  for (const SparseEntry& entry : system.entries) {
    const auto primary = std::ranges::find(primaries, entry.column, &Primary::index);
    if (primary == primaries.end()) {
      transposed.add(entry.column, entry.row, entry.value);
    } else {
      load[entry.row] += entry.value * primary->value;
    }
  }
  std::optional<UnheldMotion> worst;
  double most = 0.0;
  for (const VecX& motion : Elimination(transposed, {}).null_vectors()) {
    const double work = std::abs(motion.dot(load)) / motion.norm();
    if (work <= most) {
      continue;
    }
    most = work;
    UnheldMotion unheld;
    double largest = 0.0;
    for (int b = 1; b <= system.rows / basis.order(); ++b) {
      const Twist twist = body_twist(motion, basis, BodyId{b});
      const double size = twist.coordinates().cwiseAbs().maxCoeff();
      if (size > largest) {
        largest = size;
        unheld = {.body = BodyId{b}, .twist = (1.0 / size) * twist};
      }
    }
    worst = unheld;
  }
  return worst;
}

void fill(const Mechanism& mechanism, const VecX& x, StaticSolution& solution) {
  const Topology& topology = mechanism.topology;
  solution.magnitudes.resize(static_cast<std::size_t>(topology.action_count()));
  for (int a = 0; a < topology.action_count(); ++a) {
    if (!std::ranges::binary_search(solution.check.undetermined, a)) {
      solution.magnitudes[static_cast<std::size_t>(a)] = x[a];
    }
  }
  solution.wrenches.reserve(topology.couplings.size());
  for (const CouplingTopology& coupling : topology.couplings) {
    std::optional<Wrench> sum = Wrench{};
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      const auto& magnitude = solution.magnitudes[static_cast<std::size_t>(a)];
      if (!magnitude || !sum) {
        sum = std::nullopt;
      } else {
        sum = *sum + *magnitude * mechanism.geometry.actions[static_cast<std::size_t>(a)];
      }
    }
    solution.wrenches.push_back(sum);
  }
}

}  // namespace

StaticSolution solve_action(const Mechanism& mechanism,
                            const CoordinateBasis& basis,
                            std::span<const Primary> primaries) {
  std::vector<int> columns;
  std::vector<double> known;
  for (const Primary& primary : primaries) {
    columns.push_back(primary.index);
    known.push_back(primary.value);
  }
  const Elimination elimination(action_system(mechanism.topology, mechanism.geometry, basis),
                                columns);
  StaticSolution solution;
  solution.evidence = elimination.evidence();
  solution.counts = action_counts(mechanism, basis.order(), elimination.rank());
  solution.check = check_primaries(elimination, 0, mechanism.topology.action_count());
  if (!solution.check.dependences.empty()) {
    const bool is_unheld = contradicts(solution.check, primaries);
    solution.status = is_unheld ? SolveStatus::inconsistent : SolveStatus::dependent;
    if (is_unheld) {
      solution.unheld = find_unheld(
          action_system(mechanism.topology, mechanism.geometry, basis), basis, primaries);
    }
    return solution;
  }
  solution.status = solution.check.missing > 0 ? SolveStatus::underdetermined : SolveStatus::solved;
  const EliminationSolution solved = elimination.solve(known, {});
  solution.residual = solved.residual;
  fill(mechanism, solved.x, solution);
  return solution;
}

}  // namespace kinestat
