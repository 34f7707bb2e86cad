#include "statics/pretension.hpp"

#include <algorithm>

#include "math/dense/linear_programme.hpp"
#include "math/dense/span.hpp"
#include "statics/equilibrium.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

namespace {

// The self-stresses that no actuator takes part in, one a column.
MatX stresses_without_actuators(const Mechanism& mechanism, const CoordinateBasis& basis) {
  const Equilibrium equilibrium(mechanism, basis, mechanism.topology.driving_actions());
  const std::vector<VecX> vectors = equilibrium.self_stresses();
  MatX stresses(mechanism.topology.action_count(), static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    stresses.col(static_cast<Eigen::Index>(j)) = vectors[j];
  }
  return stresses;
}

// The factors y of the columns of `pulls` for which they pull at least `least` on each segment and
// the sum is least: pulls y - s = least with s >= 0. Empty if there are none.
std::optional<VecX> least_factors(const MatX& pulls, const VecX& least) {
  const Eigen::Index n = pulls.cols();
  const Eigen::Index segments = pulls.rows();
  MatX A(segments, 2 * n + segments);
  A.leftCols(n) = pulls;
  A.middleCols(n, n) = -pulls;
  A.rightCols(segments) = -MatX::Identity(segments, segments);
  VecX costs = VecX::Zero(A.cols());
  costs.tail(segments).setOnes();
  const std::optional<VecX> x = find_least_cost(A, least, costs);
  return x ? std::optional<VecX>(x->head(n) - x->segment(n, n)) : std::nullopt;
}

}  // namespace

std::optional<VecX> find_pretension(const Mechanism& mechanism,
                                    const CoordinateBasis& basis,
                                    const StaticSolution& solution) {
  const std::vector<int> tensions = find_tensions(mechanism.topology);
  VecX least(static_cast<Eigen::Index>(tensions.size()));
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    const std::optional<double> force = solution.magnitudes[static_cast<std::size_t>(tensions[i])];
    if (!force) {
      return std::nullopt;
    }
    least[static_cast<Eigen::Index>(i)] = std::max(0.0, -*force);
  }
  const MatX stresses = stresses_without_actuators(mechanism, basis);
  if (stresses.cols() == 0 || tensions.empty()) {
    return std::nullopt;
  }
  // Only combinations that differ in the tensions, so that nothing else is stressed for nothing.
  const MatX parts = orthonormal_range(stresses(tensions, Eigen::all).transpose());
  const MatX pulls = stresses(tensions, Eigen::all) * parts;
  const double size = pulls.cols() == 0 ? 0.0 : pulls.cwiseAbs().maxCoeff();
  if (size == 0.0) {
    return std::nullopt;
  }
  const std::optional<VecX> factors = least_factors(pulls / size, least);
  return factors ? std::optional<VecX>(stresses * (parts * (*factors / size))) : std::nullopt;
}

}  // namespace kinestat
