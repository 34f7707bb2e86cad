#include "kinematics/velocity.hpp"

#include <algorithm>
#include <cmath>

#include "core/rounding.hpp"
#include "core/tolerance.hpp"
#include "kinematics/bounded_motion.hpp"
#include "math/elimination/bounded_solve.hpp"
#include "math/elimination/data_zero.hpp"
#include "mechanism/position_error.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

void fill(const Mechanism& mechanism,
          const CoordinateBasis& basis,
          const VecX& x,
          KinematicSolution& solution) {
  const Topology& topology = mechanism.topology;
  solution.rates.reserve(topology.freedoms.size());
  solution.bodies.reserve(topology.bodies.size());
  solution.couplings.reserve(topology.couplings.size());
  for (int f = 0; f < topology.freedom_count(); ++f) {
    solution.rates.push_back(rate_unit(topology, basis, f) *
                             x[velocity_column(topology, basis, f)]);
  }
  for (int b = 0; b < topology.body_count(); ++b) {
    solution.bodies.push_back(body_twist(x, basis, BodyId{b}));
  }
  finish_motions(mechanism, solution);
}

// What follows from a magnitude that was searched for is asked for its bound.
AccuracyRequest request_for(std::span<const Primary> primaries, AccuracyRequest request) {
  const bool is_searched =
      std::ranges::any_of(primaries, [](const Primary& one) { return one.relative_bound != 0.0; });
  if (is_searched && request.accuracy == Accuracy::fast) {
    request.accuracy = Accuracy::automatic;
  }
  return request;
}

// What primaries may be off by moves all that follows from them: what that does not tell from zero
// is zero.
void add_bounds_of(std::span<const Primary> primaries,
                   std::span<const double> known,
                   const Elimination& elimination,
                   BoundedSolution& solved) {
  for (std::size_t i = 0; i < primaries.size(); ++i) {
    if (primaries[i].relative_bound == 0.0) {
      continue;
    }
    std::vector<double> off(known.size(), 0.0);
    off[i] = primaries[i].relative_bound * known[i];
    const VecX moved = elimination.solve(off, {}).x.cwiseAbs();
    VecX bound = moved;
    if (solved.bound) {
      *solved.bound += moved;
      bound = *solved.bound;
    }
    VecX& x = solved.solution.x;
    x = (x.array().abs() <= bound.array()).select(0.0, x);
  }
}

// What is known of the error of the rates.
AnswerEvidence evidence_of(const Topology& topology,
                           const CoordinateBasis& basis,
                           const BoundedSolution& solved,
                           const std::vector<bool>& counts) {
  AnswerEvidence result{.precision = solved.precision, .error_bound = {}, .bounds = {}};
  if (!solved.bound) {
    return result;
  }
  result.error_bound = worst_relative_error(solved.solution.x, *solved.bound, counts, 0.0);
  result.bounds.reserve(topology.freedoms.size());
  for (int f = 0; f < topology.freedom_count(); ++f) {
    result.bounds.push_back(rate_unit(topology, basis, f) *
                            (*solved.bound)[velocity_column(topology, basis, f)]);
  }
  return result;
}

// What rounding of the drawing counts for, as share of the sizes: friction and losses ask for the
// sense of a motion, and that of mere rounding is none.
double drawing_error(const Mechanism& mechanism) {
  return mechanism.frictions.empty() && mechanism.lossy_meshes.empty() ? 0.0 : kDataRounding;
}

// Whether no number is too large, or none at all.
bool is_in_range(const KinematicSolution& solution) {
  const auto holds = [](double x) { return std::abs(x) <= kLargestMagnitude; };
  return std::ranges::all_of(solution.rates, holds) &&
         std::ranges::all_of(solution.bodies, [&](const Twist& twist) {
           return std::ranges::all_of(twist.coordinates(), holds);
         });
}

}  // namespace

KinematicSolution solve_velocity(const Mechanism& mechanism,
                                 const CoordinateBasis& basis,
                                 std::span<const Primary> primaries,
                                 const AccuracyRequest& request) {
  const Topology& topology = mechanism.topology;
  std::vector<int> columns;
  std::vector<double> known;
  columns.reserve(primaries.size());
  known.reserve(primaries.size());
  for (const Primary& primary : primaries) {
    columns.push_back(velocity_column(topology, basis, primary.index));
    known.push_back(primary.value / rate_unit(topology, basis, primary.index));
  }
  const Elimination elimination(velocity_system(topology, mechanism.geometry, basis), columns);
  KinematicSolution solution;
  solution.evidence = elimination.evidence();
  solution.counts = motion_counts(mechanism, basis.order(), elimination.rank());
  InexactBlocks inexact{.rows = basis.order(),
                        .first_column = velocity_column(topology, basis, 0),
                        .share = std::max(position_error(mechanism), kDataRounding)};
  solution.check = check_primaries(
      elimination, inexact, rate_units(topology, basis), {}, topology.driven_freedoms());
  if (!solution.check.dependences.empty()) {
    solution.status = SolveStatus::dependent;
    return solution;
  }
  if (solution.check.missing > 0) {
    solution.status = SolveStatus::underdetermined;
    return solution;
  }
  const std::vector<bool> counts(
      static_cast<std::size_t>(velocity_column(topology, basis, topology.freedom_count())), true);
  BoundedSolution solved =
      solve_to_digits(elimination, known, {}, request_for(primaries, request), counts);
  add_bounds_of(primaries, known, elimination, solved);
  inexact.share = std::max(position_error(mechanism), drawing_error(mechanism));
  if (inexact.share > 0.0) {
    settle_inexact(elimination, {}, inexact, solved.solution.x);
  }
  solution.residual = solved.solution.residual;
  solution.answer = evidence_of(topology, basis, solved, counts);
  fill(mechanism, basis, solved.solution.x, solution);
  if (!is_in_range(solution)) {
    solution.status = SolveStatus::overflow;
  }
  return solution;
}

}  // namespace kinestat
