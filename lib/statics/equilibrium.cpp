#include "statics/equilibrium.hpp"

#include <utility>

#include "core/contract.hpp"
#include "math/bounded_solve.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

std::vector<double> action_units(const Topology& topology, const CoordinateBasis& basis) {
  std::vector<double> units;
  for (int a = 0; a < topology.action_count(); ++a) {
    units.push_back(action_unit(topology, basis, a));
  }
  return units;
}

}  // namespace

Equilibrium::Equilibrium(const Mechanism& mechanism,
                         CoordinateBasis basis,
                         std::vector<int> primaries)
    : basis_(std::move(basis)),
      primaries_(std::move(primaries)),
      driving_(mechanism.topology.driving_actions()),
      units_(action_units(mechanism.topology, basis_)),
      body_count_(mechanism.topology.body_count()),
      elimination_(action_system(mechanism.topology, mechanism.geometry, basis_), primaries_),
      counts_(action_counts(mechanism, basis_.order(), elimination_.rank())) {}

PrimaryCheck Equilibrium::check(std::span<const BodyWrench> loads) const {
  return check_primaries(
      elimination_, 0, units_, load_vector(body_count_, basis_, loads), driving_);
}

EquilibriumActions Equilibrium::solve(std::span<const double> known,
                                      std::span<const BodyWrench> loads) const {
  return solve_to({}, {}, known, loads);
}

EquilibriumActions Equilibrium::solve_to(const AccuracyRequest& request,
                                         const std::vector<bool>& counts,
                                         std::span<const double> known,
                                         std::span<const BodyWrench> loads) const {
  KINESTAT_EXPECTS(known.size() == primaries_.size());
  std::vector<double> in_units;
  for (std::size_t i = 0; i < known.size(); ++i) {
    in_units.push_back(known[i] / units_[static_cast<std::size_t>(primaries_[i])]);
  }
  const BoundedSolution solved = solve_to_digits(
      elimination_, in_units, load_vector(body_count_, basis_, loads), request, counts);
  const Eigen::Map<const VecX> units(units_.data(), static_cast<Eigen::Index>(units_.size()));
  EquilibriumActions result{.magnitudes = units.cwiseProduct(solved.solution.x),
                            .residual = solved.solution.residual,
                            .consistent = solved.solution.consistent,
                            .answer = {.rung = solved.rung, .error_bound = {}, .bounds = {}}};
  if (solved.bound) {
    const VecX bounds = units.cwiseProduct(*solved.bound);
    result.answer.error_bound = worst_relative_error(solved.solution.x, *solved.bound, counts);
    result.answer.bounds.assign(bounds.begin(), bounds.end());
  }
  return result;
}

double Equilibrium::residual(const VecX& magnitudes, std::span<const BodyWrench> loads) const {
  const Eigen::Map<const VecX> units(units_.data(), static_cast<Eigen::Index>(units_.size()));
  return elimination_.residual(magnitudes.cwiseQuotient(units),
                               load_vector(body_count_, basis_, loads));
}

std::vector<VecX> Equilibrium::self_stresses() const {
  const Eigen::Map<const VecX> units(units_.data(), static_cast<Eigen::Index>(units_.size()));
  std::vector<VecX> vectors = elimination_.null_vectors();
  for (VecX& vector : vectors) {
    vector.array() *= units.array();
  }
  return vectors;
}

}  // namespace kinestat
