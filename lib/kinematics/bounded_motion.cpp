#include "kinematics/bounded_motion.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/rounding.hpp"
#include "screw/bounded_screw_sum.hpp"

namespace kinestat {

namespace {

// The couplings at each body as a chain of their ends, in the order of the Topology, and which
// bodies are reached from the ground over them. One list holds all of it.
class Reach {
 public:
  explicit Reach(const Topology& topology)
      : body_count_(topology.bodies.size()),
        list_(3 * body_count_ + 2 * topology.couplings.size(), kNone) {
    for (int e = topology.coupling_count() - 1; e >= 0; --e) {
      const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
      chain(2 * e, coupling.tail.value);
      chain(2 * e + 1, coupling.head.value);
    }
    add(0);
  }

  /// An end is twice the index of its coupling, and one more at the head.
  int first_end(int body) const { return list_[index(body)]; }

  int next_end(int end) const { return list_[3 * body_count_ + index(end)]; }

  bool has(int body) const { return list_[body_count_ + index(body)] != kNone; }

  void add(int body) {
    list_[body_count_ + index(body)] = 0;
    list_[2 * body_count_ + reached_++] = body;
  }

  /// How many bodies are reached, and which one was the n-th.
  std::size_t size() const { return reached_; }

  int body(std::size_t n) const { return list_[2 * body_count_ + n]; }

  static constexpr int kNone = -1;

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void chain(int end, int body) {
    list_[3 * body_count_ + index(end)] = list_[index(body)];
    list_[index(body)] = end;
  }

  std::size_t body_count_ = 0;
  std::vector<int> list_;  // first end of each body, whether it is reached, the order; next ends
  std::size_t reached_ = 0;
};

Twist sizes_of(const Twist& twist) {
  return {.angular = twist.angular.cwiseAbs(), .linear = twist.linear.cwiseAbs()};
}

void settle_twist(const Twist& bound, Twist& twist) {
  settle(bound.angular, twist.angular);
  settle(bound.linear, twist.linear);
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
  const Vec3 at = geometry.points[static_cast<std::size_t>(coupling.value)];
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
    coupling_bounds.push_back({.angular = twist.angular.bound, .linear = twist.linear.bound});
    motion.couplings.push_back({.angular = twist.angular.value, .linear = twist.linear.value});
    settle_twist(coupling_bounds.back(), motion.couplings.back());
  }
  motion.body_bounds.assign(topology.bodies.size(), Twist{});
  Reach reach(topology);
  for (std::size_t n = 0; n < reach.size(); ++n) {
    const int body = reach.body(n);
    const auto from = static_cast<std::size_t>(body);
    for (int end = reach.first_end(body); end != Reach::kNone; end = reach.next_end(end)) {
      const auto e = static_cast<std::size_t>(end / 2);
      const bool is_forward = end % 2 == 0;
      const CouplingTopology& coupling = topology.couplings[e];
      const int other = is_forward ? coupling.head.value : coupling.tail.value;
      if (reach.has(other)) {
        continue;
      }
      reach.add(other);
      const auto to = static_cast<std::size_t>(other);
      const double sense = is_forward ? 1.0 : -1.0;
      const Twist missed = motion.bodies[to] - motion.bodies[from] - sense * motion.couplings[e];
      const Twist sizes = sizes_of(motion.bodies[to]) + sizes_of(motion.bodies[from]);
      motion.body_bounds[to] =
          motion.body_bounds[from] + coupling_bounds[e] + sizes_of(missed) + 2.0 * kEpsilon * sizes;
    }
  }
  for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
    settle_twist(motion.body_bounds[b], motion.bodies[b]);
  }
}

}  // namespace kinestat
