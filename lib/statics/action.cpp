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

// How much a body moves [m/s]: at its reference point, or by turning over the mechanism's length.
double size_of(const Twist& twist, const Vec3& reference, double length) {
  return std::max(velocity_at(twist, reference).norm(), length * twist.angular.norm());
}

// The body that moves most in a virtual motion of all bodies, given in the coordinates that are
// dual to those of `basis`.
UnheldMotion greatest_motion(const VecX& motion,
                             const CoordinateBasis& basis,
                             const Geometry& geometry) {
  UnheldMotion greatest;
  double largest = 0.0;
  for (int b = 1; b <= motion.size() / basis.order(); ++b) {
    const VecX part = motion.segment(basis.order() * (b - 1), basis.order());
    const Twist twist = Twist::from_coordinates((basis.basis * part).cwiseQuotient(basis.unit));
    const double size = size_of(
        twist, geometry.references[static_cast<std::size_t>(b)] - geometry.origin, geometry.length);
    if (size > largest) {
      largest = size;
      greatest = {.body = BodyId{b}, .twist = (geometry.length / size) * twist};
    }
  }
  return greatest;
}

// A virtual motion reciprocal to every secondary action but not to the primaries: the solution of
// the transposed system. Empty if rounding hides it.
std::optional<UnheldMotion> find_unheld(const Mechanism& mechanism,
                                        const CoordinateBasis& basis,
                                        std::span<const Primary> primaries) {
  const SparseMatrix system = action_system(mechanism.topology, mechanism.geometry, basis);
  SparseMatrix transposed{.rows = system.columns, .columns = system.rows, .entries = {}};
  VecX load = VecX::Zero(system.rows);
  for (const SparseEntry& entry : system.entries) {
    const auto primary = std::ranges::find(primaries, entry.column, &Primary::index);
    if (primary == primaries.end()) {
      transposed.add(entry.column, entry.row, entry.value);
    } else {
      const double unit = action_unit(mechanism.topology, basis, primary->index);
      load[entry.row] += entry.value * primary->value / unit;
    }
  }
  std::optional<UnheldMotion> worst;
  double most = 0.0;
  for (const VecX& motion : Elimination(std::move(transposed), {}).null_vectors()) {
    const double work = std::abs(motion.dot(load)) / motion.norm();
    if (work > most) {
      most = work;
      worst = greatest_motion(motion, basis, mechanism.geometry);
    }
  }
  return worst;
}

std::vector<double> action_units(const Topology& topology, const CoordinateBasis& basis) {
  std::vector<double> units;
  for (int a = 0; a < topology.action_count(); ++a) {
    units.push_back(action_unit(topology, basis, a));
  }
  return units;
}

void fill(const Mechanism& mechanism,
          const CoordinateBasis& basis,
          const VecX& x,
          StaticSolution& solution) {
  const Topology& topology = mechanism.topology;
  solution.magnitudes.resize(static_cast<std::size_t>(topology.action_count()));
  for (int a = 0; a < topology.action_count(); ++a) {
    if (!std::ranges::binary_search(solution.check.undetermined, a)) {
      solution.magnitudes[static_cast<std::size_t>(a)] = action_unit(topology, basis, a) * x[a];
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

bool is_finite(const StaticSolution& solution) {
  return std::ranges::all_of(
             solution.magnitudes,
             [](const std::optional<double>& m) { return std::isfinite(m.value_or(0.0)); }) &&
         std::ranges::all_of(solution.wrenches, [](const std::optional<Wrench>& wrench) {
           return wrench.value_or(Wrench{}).coordinates().allFinite();
         });
}

}  // namespace

StaticSolution solve_action(const Mechanism& mechanism,
                            const CoordinateBasis& basis,
                            std::span<const Primary> primaries) {
  std::vector<int> columns;
  std::vector<double> known;
  for (const Primary& primary : primaries) {
    columns.push_back(primary.index);
    known.push_back(primary.value / action_unit(mechanism.topology, basis, primary.index));
  }
  const Elimination elimination(action_system(mechanism.topology, mechanism.geometry, basis),
                                columns);
  StaticSolution solution;
  solution.evidence = elimination.evidence();
  solution.counts = action_counts(mechanism, basis.order(), elimination.rank());
  solution.check = check_primaries(elimination, 0, action_units(mechanism.topology, basis));
  if (!solution.check.dependences.empty()) {
    const bool is_unheld = contradicts(solution.check, primaries);
    solution.status = is_unheld ? SolveStatus::inconsistent : SolveStatus::dependent;
    if (is_unheld) {
      solution.unheld = find_unheld(mechanism, basis, primaries);
    }
    return solution;
  }
  solution.status = solution.check.missing > 0 ? SolveStatus::underdetermined : SolveStatus::solved;
  const EliminationSolution solved = elimination.solve(known, {});
  solution.residual = solved.residual;
  fill(mechanism, basis, solved.x, solution);
  if (!is_finite(solution)) {
    solution.status = SolveStatus::overflow;
    solution.magnitudes.clear();
    solution.wrenches.clear();
  }
  return solution;
}

}  // namespace kinestat
