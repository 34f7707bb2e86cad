#include "studies/mobility/rank_certainty.hpp"

#include <algorithm>

#include "core/tolerance.hpp"
#include "math/dense/smallest_singular_value.hpp"
#include "math/elimination/equilibrate.hpp"
#include "math/elimination/refined_solve.hpp"
#include "network/bases.hpp"
#include "network/exact_input_system.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// `shift` is the part of the rank that stands for twists of bodies.
RankCertainty certainty_of(const SparseMatrix& system, int shift) {
  const Elimination elimination(system, {});
  RankCertainty result;
  result.rank = elimination.rank() - shift;
  result.dropped = elimination.evidence().largest_dropped;
  result.upper = largest_rank(system) - shift;
  const std::vector<double> nothing;
  const bool is_regular = RefinedSolve(elimination, nothing, {}).error_bound().has_value();
  result.lower = is_regular ? result.rank : 0;
  if (result.lower == result.upper) {
    result.how = "structural";
  }
  return result;
}

// An oblique basis is itself a decision on a rank: then all coordinates.
CoordinateBasis undecided(CoordinateBasis basis, ScrewKind kind, const Mechanism& mechanism) {
  return basis.is_made_of_coordinates() ? basis : spatial_basis(kind, mechanism.geometry.length);
}

std::string_view word_of(ExactInputProof proof) {
  switch (proof) {
    case ExactInputProof::structural:
      return "structural";
    case ExactInputProof::elimination:
      return "elimination";
    case ExactInputProof::modular:
      return "modular";
    case ExactInputProof::digits:
      return "digits";
  }
  return "";
}

// Jacobi's method takes some ten n³ operations.
constexpr int kLargestSpectrum = 200;

// The k-th singular value of the scaled doubles.
std::optional<double> deciding_value(const ExactInputMatrix& system, int k) {
  if (std::max(system.rows, system.columns) > kLargestSpectrum) {
    return std::nullopt;
  }
  SparseMatrix doubles{.rows = system.rows, .columns = system.columns, .entries = {}};
  for (const ExactInputEntry& entry : system.entries) {
    doubles.add(entry.row, entry.column, entry.value.value);
  }
  const Scaling scaling = find_scaling(doubles);
  for (SparseEntry& entry : doubles.entries) {
    entry.value *= scaling.rows[static_cast<std::size_t>(entry.row)] *
                   scaling.columns[static_cast<std::size_t>(entry.column)];
  }
  const double share = singular_value_share(doubles.dense(), k);
  return share <= kEpsilon * std::max(system.rows, system.columns) ? 0.0 : share;
}

void add_exact_input(const ExactInputMatrix& system, int shift, RankCertainty& certainty) {
  std::optional<ExactInputRank> found = find_exact_input_rank(system, largest_rank(system));
  if (!found) {
    return;
  }
  found->rank -= shift;
  certainty.exact_input = found;
  if (certainty.differs()) {
    certainty.deciding = deciding_value(system, std::max(found->rank, certainty.rank) + shift);
  }
  if (certainty.how != "structural") {
    certainty.how = certainty.differs() ? "numeric" : word_of(found->proof);
  }
}

}  // namespace

RankCertainty find_motion_certainty(const Mechanism& mechanism) {
  const CoordinateBasis basis = undecided(
      motion_basis(mechanism.geometry, OrderChoice::minimal), ScrewKind::twist, mechanism);
  return certainty_of(velocity_system(mechanism.topology, mechanism.geometry, basis),
                      basis.order() * (mechanism.topology.body_count() - 1));
}

RankCertainty find_action_certainty(const Mechanism& mechanism) {
  const CoordinateBasis basis = undecided(
      action_basis(mechanism.geometry, OrderChoice::minimal), ScrewKind::wrench, mechanism);
  return certainty_of(action_system(mechanism.topology, mechanism.geometry, basis), 0);
}

void add_exact_input_motions(const Mechanism& mechanism,
                             const ExactInputMechanism& exact_input,
                             RankCertainty& certainty) {
  const CoordinateBasis basis = spatial_basis(ScrewKind::twist, mechanism.geometry.length);
  add_exact_input(exact_input_velocity_system(mechanism.topology, exact_input.motions, basis),
                  basis.order() * (mechanism.topology.body_count() - 1),
                  certainty);
}

void add_exact_input_actions(const Mechanism& mechanism,
                             const ExactInputMechanism& exact_input,
                             RankCertainty& certainty) {
  const CoordinateBasis basis = spatial_basis(ScrewKind::wrench, mechanism.geometry.length);
  add_exact_input(
      exact_input_action_system(mechanism.topology, exact_input.actions, basis), 0, certainty);
}

}  // namespace kinestat
