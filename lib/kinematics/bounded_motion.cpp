#include "kinematics/bounded_motion.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/rounding.hpp"
#include "screw/bounded_screw_sum.hpp"

namespace kinestat {

namespace {

// The couplings at each body, one after the other.
struct Incidence {
  std::vector<std::size_t> first;  // of a body, and one more
  std::vector<int> couplings;
};

Incidence incidence_of(const Topology& topology) {
  Incidence result{.first = std::vector<std::size_t>(topology.bodies.size() + 2, 0),
                   .couplings = std::vector<int>(2 * topology.couplings.size())};
  for (const CouplingTopology& coupling : topology.couplings) {
    ++result.first[static_cast<std::size_t>(coupling.tail.value) + 2];
    ++result.first[static_cast<std::size_t>(coupling.head.value) + 2];
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    for (const BodyId body : {coupling.tail, coupling.head}) {
      result.couplings[result.first[static_cast<std::size_t>(body.value) + 1]++] = e;
    }
  }
  return result;
}

Twist bounds_of(const BoundedTwist& twist) {
  return {.angular = twist.angular.bound, .linear = twist.linear.bound};
}

Twist sizes_of(const Twist& twist) {
  return {.angular = twist.angular.cwiseAbs(), .linear = twist.linear.cwiseAbs()};
}

}  // namespace

BoundedNumber bounded_rate(const KinematicSolution& motion, int freedom) {
  const auto f = static_cast<std::size_t>(freedom);
  const double rate = motion.rates[f];
  const std::vector<double>& bounds = motion.answer.bounds;
  return {.value = rate, .bound = bounds.empty() ? kSolvedRounding * std::abs(rate) : bounds[f]};
}

BoundedTwist bounded_coupling(const Mechanism& mechanism,
                              const KinematicSolution& motion,
                              CouplingId coupling) {
  const CouplingTopology& one = mechanism.topology.coupling(coupling);
  const Geometry& geometry = mechanism.geometry;
  const Vec3 at = geometry.points[static_cast<std::size_t>(coupling.value)] - geometry.origin;
  BoundedScrewSum sum(at);
  for (int f = one.first_freedom; f < one.first_freedom + one.freedom_count; ++f) {
    const Twist& unit = geometry.motions[static_cast<std::size_t>(f)];
    sum.add(bounded_rate(motion, f), unit.angular, unit.linear);
  }
  return {.angular = sum.line(), .linear = sum.moment()};
}

BoundedTwist bounded_body(const KinematicSolution& motion, BodyId body) {
  const auto b = static_cast<std::size_t>(body.value);
  const Twist& value = motion.bodies[b];
  if (motion.body_bounds.empty()) {
    return written(value);
  }
  const Twist& bound = motion.body_bounds[b];
  return {.angular = {.value = value.angular, .bound = bound.angular},
          .linear = {.value = value.linear, .bound = bound.linear}};
}

void finish_motions(const Mechanism& mechanism, KinematicSolution& motion) {
  const Topology& topology = mechanism.topology;
  std::vector<Twist> coupling_bounds;
  coupling_bounds.reserve(topology.couplings.size());
  motion.couplings.clear();
  motion.couplings.reserve(topology.couplings.size());
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const BoundedTwist twist = bounded_coupling(mechanism, motion, CouplingId{e});
    coupling_bounds.push_back(bounds_of(twist));
    motion.couplings.push_back(twist.zeroed());
  }
  motion.body_bounds.assign(topology.bodies.size(), Twist{});
  const Incidence incidence = incidence_of(topology);
  std::vector<bool> is_reached(topology.bodies.size(), false);
  std::vector<int> reached;
  reached.reserve(topology.bodies.size());
  reached.push_back(0);
  is_reached[0] = true;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const auto from = static_cast<std::size_t>(reached[next]);
    for (std::size_t i = incidence.first[from]; i < incidence.first[from + 1]; ++i) {
      const auto e = static_cast<std::size_t>(incidence.couplings[i]);
      const CouplingTopology& coupling = topology.couplings[e];
      const bool is_forward = coupling.tail.value == reached[next];
      const int other = is_forward ? coupling.head.value : coupling.tail.value;
      const auto to = static_cast<std::size_t>(other);
      if (is_reached[to]) {
        continue;
      }
      is_reached[to] = true;
      reached.push_back(other);
      const double sense = is_forward ? 1.0 : -1.0;
      const Twist missed = motion.bodies[to] - motion.bodies[from] - sense * motion.couplings[e];
      const Twist sizes = sizes_of(motion.bodies[to]) + sizes_of(motion.bodies[from]);
      motion.body_bounds[to] =
          motion.body_bounds[from] + coupling_bounds[e] + sizes_of(missed) + 2.0 * kEpsilon * sizes;
    }
  }
  for (int b = 0; b < topology.body_count(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    motion.bodies[i] = bounded_body(motion, BodyId{b}).zeroed();
  }
}

}  // namespace kinestat
