#include "studies/inputs/cable_tension.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/rounding.hpp"
#include "math/dense/linear_programme.hpp"
#include "math/dense/span.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "network/bases.hpp"
#include "studies/inputs/solution_space.hpp"

namespace kinestat {

namespace {

// The same mechanism with cables that stretch: each segment has its length as a last freedom.
struct Loosened {
  Mechanism mechanism;
  std::vector<int> stretches;  ///< the freedom of each segment
  std::vector<int> drivable;   ///< freedoms that an actuator may drive
  std::vector<int> original;   ///< of each of these, its number in the mechanism
};

bool is_slip(const Mechanism& mechanism, int coupling) {
  return std::ranges::any_of(mechanism.contacts, [&](const CableContact& contact) {
    return contact.slips && contact.slips->value == coupling;
  });
}

// Positive stretches lengthen the segment: the head goes against the force that it is pulled with.
Twist stretch_of(const Mechanism& mechanism, const CouplingTopology& segment) {
  const Vec3& pull =
      mechanism.geometry.actions[static_cast<std::size_t>(segment.first_action)].force;
  return Twist{.angular = Vec3::Zero(), .linear = -pull};
}

Loosened loosen(const Mechanism& mechanism) {
  Loosened result;
  result.mechanism = mechanism;
  Topology& topology = result.mechanism.topology;
  topology.freedoms.clear();
  std::vector<Twist>& motions = result.mechanism.geometry.motions;
  motions.clear();
  for (int e = 0; e < topology.coupling_count(); ++e) {
    CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    const int first = topology.freedom_count();
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      if (coupling.type != CouplingType::cable && !is_slip(mechanism, e)) {
        result.drivable.push_back(topology.freedom_count());
        result.original.push_back(f);
      }
      topology.freedoms.push_back(mechanism.topology.freedoms[static_cast<std::size_t>(f)]);
      motions.push_back(mechanism.geometry.motions[static_cast<std::size_t>(f)]);
    }
    if (coupling.bears_tension()) {
      result.stretches.push_back(topology.freedom_count());
      topology.freedoms.push_back(
          {.coupling = CouplingId{e}, .name = "stretch", .is_rotation = false});
      motions.push_back(stretch_of(mechanism, coupling));
      ++coupling.freedom_count;
    }
    coupling.first_freedom = first;
  }
  return result;
}

SolutionSpace minimal_space(const Mechanism& mechanism) {
  return motion_space(mechanism, motion_basis(mechanism.geometry, OrderChoice::minimal));
}

MatX rows_of(const SolutionSpace& space, const std::vector<int>& rows) {
  return space.basis(rows, Eigen::all);
}

int rank_of(const MatX& rows) {
  return rows.size() == 0 ? 0 : static_cast<int>(orthonormal_range(rows.transpose()).cols());
}

// The numbers of a basic solution that rounding of the equations does not make: entries of
// orthonormal rows are off by that of 1, whatever their own size.
VecX told_from_zero(const MatX& A, const VecX& b, const VecX& x) {
  std::vector<Eigen::Index> used;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x[i] != 0.0) {
      used.push_back(i);
    }
  }
  if (used.empty()) {
    return x;
  }
  const MatX basic = A(Eigen::all, used);
  const MatX inverse = basic.colPivHouseholderQr().solve(MatX::Identity(A.rows(), A.rows()));
  const double error = kDataRounding * (x.cwiseAbs().sum() + b.cwiseAbs().maxCoeff());
  VecX result = x;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const double bound = inverse.row(static_cast<Eigen::Index>(i)).cwiseAbs().sum() * error;
    result[used[i]] = zero_within_bound(x[used[i]], bound);
  }
  return result;
}

// The actions of the drives are in equilibrium with the tensions if no motion of the loosened
// mechanism gives them power (Tellegen): Φ_drivesᵀ τ = Φ_stretchesᵀ T. With T = 1 + t, in units of
// the space, and τ the difference of two numbers that are not negative. Empty if there is none.
std::optional<VecX> find_drives(const MatX& stretches, const MatX& drives) {
  const Eigen::Index segments = stretches.rows();
  const Eigen::Index count = drives.rows();
  MatX rows(segments + count, stretches.cols());
  rows.topRows(segments) = stretches;
  rows.bottomRows(count) = drives;
  const MatX motions = orthonormal_range(rows).transpose();
  const MatX tensions = motions.leftCols(segments);
  MatX A(motions.rows(), 2 * count + segments);
  A.leftCols(count) = motions.rightCols(count);
  A.middleCols(count, count) = -motions.rightCols(count);
  A.rightCols(segments) = -tensions;
  // Tensions of 1 may be in equilibrium already, but for rounding.
  VecX sums = tensions * VecX::Ones(segments);
  const double largest = tensions.size() == 0 ? 0.0 : tensions.cwiseAbs().maxCoeff();
  for (double& sum : sums) {
    sum = std::abs(sum) > kRankZero * largest ? sum : 0.0;
  }
  VecX costs = VecX::Zero(A.cols());
  costs.head(2 * count).setOnes();
  const std::optional<VecX> x = find_least_cost(A, sums, costs);
  if (!x) {
    return std::nullopt;
  }
  const VecX sure = told_from_zero(A, sums, *x);
  return VecX(sure.head(count) - sure.segment(count, count));
}

// Chooses drives that pull on every segment.
class Pretension {
 public:
  Pretension(const Loosened& loosened, const SolutionSpace& motions)
      : loosened_(loosened), motions_(motions), space_(minimal_space(loosened.mechanism)) {}

  // The least sum of actions, then without each drive that can be spared, until no more than one
  // depends on the others.
  std::optional<std::vector<TensioningDrive>> find_few() const {
    std::vector<std::size_t> allowed(loosened_.drivable.size());
    std::iota(allowed.begin(), allowed.end(), std::size_t{0});
    std::optional<std::vector<TensioningDrive>> drives = find_among(allowed);
    std::optional<std::vector<TensioningDrive>> best = drives;
    for (std::size_t i = 0; best && i < drives->size() && dependences(*best) > 1;) {
      std::vector<std::size_t> fewer = allowed;
      const int spared = (*drives)[i].freedom;
      std::erase_if(fewer, [&](std::size_t d) { return loosened_.original[d] == spared; });
      const std::optional<std::vector<TensioningDrive>> found = find_among(fewer);
      if (!found) {
        ++i;
        continue;
      }
      drives = found;
      allowed = std::move(fewer);
      i = 0;
      if (dependences(*drives) < dependences(*best)) {
        best = drives;
      }
    }
    return best;
  }

  // How many of the motions of the drives follow from the others.
  int dependences(const std::vector<TensioningDrive>& drives) const {
    std::vector<int> freedoms;
    for (const TensioningDrive& drive : drives) {
      freedoms.push_back(drive.freedom);
    }
    return static_cast<int>(drives.size()) - rank_of(rows_of(motions_, freedoms));
  }

 private:
  std::optional<std::vector<TensioningDrive>> find_among(
      const std::vector<std::size_t>& allowed) const {
    std::vector<int> freedoms;
    for (const std::size_t d : allowed) {
      freedoms.push_back(loosened_.drivable[d]);
    }
    const std::optional<VecX> actions =
        find_drives(rows_of(space_, loosened_.stretches), rows_of(space_, freedoms));
    if (!actions) {
      return std::nullopt;
    }
    const auto unit = [&](int freedom) { return space_.units[static_cast<std::size_t>(freedom)]; };
    std::vector<TensioningDrive> drives;
    for (std::size_t i = 0; i < allowed.size(); ++i) {
      const double action = (*actions)[static_cast<Eigen::Index>(i)];
      if (action != 0.0) {
        const auto freedom = static_cast<std::size_t>(freedoms[i]);
        drives.push_back(
            {.freedom = loosened_.original[allowed[i]],
             .is_couple = loosened_.mechanism.topology.freedoms[freedom].is_rotation,
             .action = action * unit(loosened_.stretches.front()) / unit(freedoms[i])});
      }
    }
    return drives;
  }

  const Loosened& loosened_;
  const SolutionSpace& motions_;
  SolutionSpace space_;  ///< motions of the loosened mechanism
};

std::vector<int> slip_freedoms(const Mechanism& mechanism) {
  std::vector<int> freedoms;
  for (const CableContact& contact : mechanism.contacts) {
    if (contact.slips) {
      freedoms.push_back(mechanism.topology.coupling(*contact.slips).first_freedom);
    }
  }
  return freedoms;
}

}  // namespace

std::optional<CableTension> find_cable_tension(const Mechanism& mechanism) {
  const Loosened loosened = loosen(mechanism);
  if (loosened.stretches.empty()) {
    return std::nullopt;
  }
  const SolutionSpace motions = minimal_space(mechanism);
  CableTension result;
  result.segments = static_cast<int>(loosened.stretches.size());
  result.net_freedom = motions.dimension();
  result.without_slip = motions.dimension() - rank_of(rows_of(motions, slip_freedoms(mechanism)));
  const Pretension pretension(loosened, motions);
  const std::optional<std::vector<TensioningDrive>> drives = pretension.find_few();
  if (drives) {
    result.is_possible = true;
    result.drives = *drives;
    result.actuators = result.net_freedom + pretension.dependences(*drives);
  }
  return result;
}

}  // namespace kinestat
