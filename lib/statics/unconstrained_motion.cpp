#include "statics/unconstrained_motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/tolerance.hpp"
#include "math/elimination/elimination.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// How much a body moves [m/s]: at its reference point, or by turning over the mechanism's length.
double size_of(const Twist& twist, const Vec3& reference, double length) {
  return std::max(velocity_at(twist, reference).norm(), length * twist.angular.norm());
}

// The motion of a body in a virtual motion of all, which is given in the coordinates that are dual
// to those of `basis`. The ground, on which friction acts too, stays where it is.
Twist motion_of(BodyId body, const VecX& motion, const CoordinateBasis& basis) {
  if (body.value == 0) {
    return {};
  }
  const VecX part = motion.segment(basis.order() * (body.value - 1), basis.order());
  return Twist::from_coordinates((basis.basis * part).cwiseQuotient(basis.unit));
}

// The body that moves most, with its motion of the mechanism's length a second.
UnconstrainedMotion greatest_motion(const VecX& motion,
                                    const CoordinateBasis& basis,
                                    const Geometry& geometry) {
  UnconstrainedMotion greatest;
  double largest = 0.0;
  for (int b = 1; b <= motion.size() / basis.order(); ++b) {
    const Twist twist = motion_of(BodyId{b}, motion, basis);
    const double size =
        size_of(twist, geometry.references[static_cast<std::size_t>(b)], geometry.length);
    if (size > largest) {
      largest = size;
      greatest = {.body = BodyId{b}, .twist = (geometry.length / size) * twist, .loads = {}};
    }
  }
  return greatest;
}

std::vector<int> working_loads(const VecX& motion,
                               const CoordinateBasis& basis,
                               std::span<const BodyWrench> loads) {
  std::vector<std::pair<double, int>> works;
  for (int i = 0; i < std::ssize(loads); ++i) {
    const BodyWrench& load = loads[static_cast<std::size_t>(i)];
    works.emplace_back(std::abs(power(load.wrench, motion_of(load.body, motion, basis))), i);
  }
  std::ranges::stable_sort(works, std::greater(), &std::pair<double, int>::first);
  std::vector<int> working;
  for (const auto& [work, i] : works) {
    if (work > kConsistency * works.front().first) {
      working.push_back(i);
    }
  }
  return working;
}

// The transposed system without the primaries, which stand on the other side with the loads.
struct Transposed {
  SparseMatrix system;
  VecX known;  // what the primaries and the loads sum to, a row of the equilibrium each
};

Transposed transpose(const Mechanism& mechanism,
                     const CoordinateBasis& basis,
                     std::span<const Primary> primaries,
                     std::span<const BodyWrench> loads) {
  const Topology& topology = mechanism.topology;
  const SparseMatrix system = action_system(topology, mechanism.geometry, basis);
  Transposed result{.system = {.rows = system.columns, .columns = system.rows, .entries = {}},
                    .known = VecX::Zero(system.rows)};
  const std::vector<double> right = load_vector(topology.body_count(), basis, loads);
  for (std::size_t r = 0; r < right.size(); ++r) {
    result.known[static_cast<Eigen::Index>(r)] = -right[r];
  }
  for (const SparseEntry& entry : system.entries) {
    const auto primary = std::ranges::find(primaries, entry.column, &Primary::index);
    if (primary == primaries.end()) {
      result.system.add(entry.column, entry.row, entry.value);
    } else {
      const double unit = action_unit(topology, basis, primary->index);
      result.known[entry.row] += entry.value * primary->value / unit;
    }
  }
  return result;
}

}  // namespace

std::optional<UnconstrainedMotion> find_unconstrained_motion(const Mechanism& mechanism,
                                                             const CoordinateBasis& basis,
                                                             std::span<const Primary> primaries,
                                                             std::span<const BodyWrench> loads) {
  Transposed transposed = transpose(mechanism, basis, primaries, loads);
  VecX worst;
  double most = 0.0;
  for (const VecX& motion : Elimination(std::move(transposed.system), {}).null_vectors()) {
    const double work = std::abs(motion.dot(transposed.known)) / motion.norm();
    if (work > most) {
      most = work;
      worst = motion;
    }
  }
  if (most == 0.0) {
    return std::nullopt;
  }
  UnconstrainedMotion unconstrained = greatest_motion(worst, basis, mechanism.geometry);
  unconstrained.loads = working_loads(worst, basis, loads);
  return unconstrained;
}

}  // namespace kinestat
