#include "statics/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/contract.hpp"
#include "core/motion_tolerance.hpp"
#include "core/rounding.hpp"
#include "core/tolerance.hpp"
#include "math/dense/readable_basis.hpp"
#include "math/dense/span.hpp"
#include "math/elimination/bounded_solve.hpp"
#include "math/elimination/data_zero.hpp"
#include "mechanism/position_error.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// The power of two next to a positive number.
double rough_size(double number) {
  return std::exp2(std::ilogb(number));
}

// Gives each body that has none the largest tension of its neighbours, layer by layer.
void hand_on(const Topology& topology, std::vector<double>& largest) {
  std::vector<std::vector<std::size_t>> neighbours(largest.size());
  for (const CouplingTopology& coupling : topology.couplings) {
    const auto tail = static_cast<std::size_t>(coupling.tail.value);
    const auto head = static_cast<std::size_t>(coupling.head.value);
    neighbours[tail].push_back(head);
    neighbours[head].push_back(tail);
  }
  std::vector<std::size_t> layer;
  for (std::size_t body = 1; body < largest.size(); ++body) {
    if (largest[body] > 0.0) {
      layer.push_back(body);
    }
  }
  while (!layer.empty()) {
    std::vector<std::pair<std::size_t, double>> handed;
    for (const std::size_t body : layer) {
      for (const std::size_t other : neighbours[body]) {
        if (other != 0 && largest[other] == 0.0) {
          handed.emplace_back(other, largest[body]);
        }
      }
    }
    layer.clear();
    for (const auto& [body, tension] : handed) {
      if (largest[body] == 0.0) {
        layer.push_back(body);
      }
      largest[body] = std::max(largest[body], tension);
    }
  }
}

// The largest tension that pulls on each body, that to which the others are tied being 1; on one
// that no cable touches, what its neighbours may hand on. Zero if there is none, and of the ground.
std::vector<double> largest_tensions(const Topology& topology,
                                     const std::vector<TiedTension>& ties) {
  std::vector<double> largest(topology.bodies.size(), 0.0);
  const auto include = [&](int action, double share) {
    const CouplingTopology& segment =
        topology.coupling(topology.actions[static_cast<std::size_t>(action)].coupling);
    for (const BodyId body : {segment.tail, segment.head}) {
      double& of_body = largest[static_cast<std::size_t>(body.value)];
      of_body = body.value == 0 ? 0.0 : std::max(of_body, share);
    }
  };
  for (const TiedTension& tie : ties) {
    include(tie.action, tie.share);
    include(tie.to, 1.0);
  }
  hand_on(topology, largest);
  return largest;
}

// Where tensions are very large multiples of each other, the largest entries of rows and columns do
// not tell in which sizes actions must be counted for a rank decision: those on a body are as large
// as the largest tension on it. Powers of two, which round nothing.
std::vector<double> action_sizes(const Topology& topology, const std::vector<TiedTension>& ties) {
  std::vector<double> sizes(topology.actions.size(), 1.0);
  if (ties.empty()) {
    return sizes;
  }
  const std::vector<double> tensions = largest_tensions(topology, ties);
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const CouplingTopology& coupling = topology.coupling(topology.actions[a].coupling);
    const double tension = std::max(tensions[static_cast<std::size_t>(coupling.tail.value)],
                                    tensions[static_cast<std::size_t>(coupling.head.value)]);
    sizes[a] = tension > 0.0 ? rough_size(tension) : 1.0;
  }
  for (const TiedTension& tie : ties) {
    sizes[static_cast<std::size_t>(tie.to)] = 1.0;
    sizes[static_cast<std::size_t>(tie.action)] =
        tie.friction_share > 0.0 ? rough_size(tie.friction_share) : 1.0;
  }
  return sizes;
}

std::vector<double> sized_units(const Topology& topology,
                                const CoordinateBasis& basis,
                                const std::vector<double>& sizes,
                                const std::vector<TiedTension>& ties) {
  std::vector<double> units = action_units(topology, basis);
  std::ranges::transform(units, sizes, units.begin(), std::multiplies());
  for (const TiedTension& tie : ties) {
    units[static_cast<std::size_t>(tie.action)] = 1.0;  // the tension, in newtons as all of them
  }
  return units;
}

// The tension to which others are tied counts in the unit of forces, 1 N.
SparseMatrix tied_system(SparseMatrix system,
                         const std::vector<TiedTension>& ties,
                         const std::vector<double>& sizes,
                         int body_count,
                         const CoordinateBasis& basis) {
  std::vector<const TiedTension*> tie_of(static_cast<std::size_t>(system.columns), nullptr);
  for (const TiedTension& tie : ties) {
    tie_of[static_cast<std::size_t>(tie.action)] = &tie;
  }
  for (SparseEntry& entry : system.entries) {
    if (const TiedTension* tie = tie_of[static_cast<std::size_t>(entry.column)]) {
      entry.column = tie->to;
      entry.value *= tie->share;
    } else {
      entry.value *= sizes[static_cast<std::size_t>(entry.column)];
    }
  }
  std::erase_if(system.entries, [](const SparseEntry& entry) { return entry.value == 0.0; });
  for (const TiedTension& tie : ties) {
    const std::vector<double> column = load_vector(body_count, basis, tie.pulls);
    for (std::size_t row = 0; row < column.size(); ++row) {
      const double size = sizes[static_cast<std::size_t>(tie.action)];
      system.add(static_cast<int>(row), tie.action, -column[row] * size);
    }
  }
  return system;
}

}  // namespace

Equilibrium::Equilibrium(const Mechanism& mechanism,
                         CoordinateBasis basis,
                         std::vector<int> primaries,
                         std::vector<TiedTension> ties)
    : basis_(std::move(basis)),
      primaries_(std::move(primaries)),
      ties_(std::move(ties)),
      driving_(mechanism.topology.driving_actions()),
      sizes_(action_sizes(mechanism.topology, ties_)),
      units_(sized_units(mechanism.topology, basis_, sizes_, ties_)),
      body_count_(mechanism.topology.body_count()),
      elimination_(tied_system(action_system(mechanism.topology, mechanism.geometry, basis_),
                               ties_,
                               sizes_,
                               body_count_,
                               basis_),
                   primaries_),
      counts_(action_counts(mechanism, basis_.order(), elimination_.rank())),
      blocks_{.rows = basis_.order(), .share = std::max(position_error(mechanism), kDataRounding)} {
  if (mechanism.closure_error > 0.0) {
    find_stresses(mechanism.closure_error);
  }
}

// Where there are so many that nobody would read them, all that they touch is open; likewise where
// they are hardly different.
void Equilibrium::find_stresses(double closure_error) {
  const std::size_t count = elimination_.free_columns().size();
  if (count == 0 || count * units_.size() > kLongestList) {
    return;
  }
  const std::vector<VecX> vectors = settled_null_vectors(elimination_, blocks_);
  const Eigen::Map<const VecX> sizes(sizes_.data(), static_cast<Eigen::Index>(sizes_.size()));
  MatX stresses(static_cast<Eigen::Index>(units_.size()), static_cast<Eigen::Index>(count));
  for (std::size_t j = 0; j < count; ++j) {
    stresses.col(static_cast<Eigen::Index>(j)) = vectors[j].cwiseProduct(sizes).normalized();
  }
  stresses_ = orthonormal_range(stresses);
  is_moved_ = stresses_.cols() == stresses.cols();
  const double least = std::max(kRankZero, kClosureInActions * closure_error);
  for (Eigen::Index a = 0; a < stresses_.rows(); ++a) {
    if (stresses_.row(a).norm() > least) {
      open_.push_back(static_cast<int>(a));
    }
  }
}

// From the friction that was unknown to the tension, or how far it may be off.
void Equilibrium::tie(VecX& per_action) const {
  for (const TiedTension& one : ties_) {
    per_action[one.action] = one.share * per_action[one.to];
  }
}

PrimaryCheck Equilibrium::check(std::span<const BodyWrench> loads) const {
  PrimaryCheck check = check_primaries(
      elimination_, blocks_, units_, load_vector(body_count_, basis_, loads), driving_);
  if (is_moved_) {
    check.undetermined = open_;
  }
  return check;
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
  in_units.reserve(known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    in_units.push_back(known[i] / units_[static_cast<std::size_t>(primaries_[i])]);
  }
  const std::vector<double> right = load_vector(body_count_, basis_, loads);
  const BoundedSolution solved = solve_to_digits(elimination_, in_units, right, request, counts);
  const Eigen::Map<const VecX> units(units_.data(), static_cast<Eigen::Index>(units_.size()));
  VecX x = solved.solution.x;
  if (is_moved_) {
    const Eigen::Map<const VecX> sizes(sizes_.data(), static_cast<Eigen::Index>(sizes_.size()));
    VecX whole = x.cwiseProduct(sizes);
    whole -= stresses_ * (stresses_.transpose() * whole);
    x = whole.cwiseQuotient(sizes);
  }
  tie(x);
  EquilibriumActions result{
      .magnitudes = units.cwiseProduct(x),
      .residual = solved.solution.residual,
      .consistent = solved.solution.consistent,
      .answer = {.precision = solved.precision, .error_bound = {}, .bounds = {}}};
  if (solved.bound) {
    VecX bounds = units.cwiseProduct(*solved.bound);
    tie(bounds);
    result.answer.error_bound =
        worst_relative_error(solved.solution.x, *solved.bound, counts, largest_size(right));
    result.answer.bounds.assign(bounds.begin(), bounds.end());
  }
  return result;
}

void Equilibrium::settle(const Mechanism& mechanism,
                         std::span<const BodyWrench> loads,
                         VecX& magnitudes) const {
  const Eigen::Map<const VecX> units(units_.data(), static_cast<Eigen::Index>(units_.size()));
  VecX x = magnitudes.cwiseQuotient(units);
  for (const TiedTension& one : ties_) {
    const double size = sizes_[static_cast<std::size_t>(one.action)];
    x[one.action] = one.friction_share * x[one.to] / size;
  }
  settle_inexact(elimination_,
                 load_vector(body_count_, basis_, loads),
                 {.rows = basis_.order(), .share = position_error(mechanism)},
                 x);
  tie(x);
  magnitudes = units.cwiseProduct(x);
}

double Equilibrium::residual(const VecX& magnitudes, std::span<const BodyWrench> loads) const {
  const Eigen::Map<const VecX> units(units_.data(), static_cast<Eigen::Index>(units_.size()));
  return elimination_.residual(magnitudes.cwiseQuotient(units),
                               load_vector(body_count_, basis_, loads));
}

std::vector<VecX> Equilibrium::self_stresses() const {
  const Eigen::Map<const VecX> units(units_.data(), static_cast<Eigen::Index>(units_.size()));
  std::vector<VecX> vectors = settled_null_vectors(elimination_, blocks_);
  for (VecX& vector : vectors) {
    vector.array() *= units.array();
  }
  return vectors;
}

}  // namespace kinestat
