#include "statics/coupling_wrenches.hpp"

#include <cmath>

#include "core/rounding.hpp"
#include "screw/bounded_screw_sum.hpp"

namespace kinestat {

namespace {

std::optional<BoundedWrench> sum_of_actions(const Mechanism& mechanism,
                                            const StaticSolution& solution,
                                            std::size_t e) {
  const CouplingTopology& coupling = mechanism.topology.couplings[e];
  const Geometry& geometry = mechanism.geometry;
  const Vec3 at = geometry.points[e] - geometry.origin;
  BoundedScrewSum sum(at);
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    const auto i = static_cast<std::size_t>(a);
    if (!solution.magnitudes[i]) {
      return std::nullopt;
    }
    const Wrench& unit = geometry.actions[i];
    sum.add(bounded_action(solution, a), unit.force, unit.moment);
  }
  return BoundedWrench{.moment = sum.moment(), .force = sum.line()};
}

}  // namespace

BoundedNumber bounded_action(const StaticSolution& solution, int action) {
  const auto a = static_cast<std::size_t>(action);
  const double magnitude = *solution.magnitudes[a];
  const std::vector<double>& bounds = solution.answer.bounds;
  return {.value = magnitude,
          .bound = bounds.empty() ? kSolvedRounding * std::abs(magnitude) : bounds[a]};
}

std::optional<BoundedWrench> bounded_wrench(const StaticSolution& solution, CouplingId coupling) {
  const auto e = static_cast<std::size_t>(coupling.value);
  const std::optional<Wrench>& value = solution.wrenches[e];
  if (!value) {
    return std::nullopt;
  }
  if (solution.wrench_bounds.empty()) {
    return written(*value);
  }
  const Wrench& bound = solution.wrench_bounds[e];
  return BoundedWrench{.moment = {.value = value->moment, .bound = bound.moment},
                       .force = {.value = value->force, .bound = bound.force}};
}

void make_wrenches(const Mechanism& mechanism, StaticSolution& solution) {
  std::vector<std::optional<BoundedWrench>> sums;
  sums.reserve(mechanism.topology.couplings.size());
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    sums.push_back(sum_of_actions(mechanism, solution, e));
  }
  for (const FrictionAction& friction : solution.friction) {
    std::optional<BoundedWrench>& sum = sums[static_cast<std::size_t>(friction.coupling.value)];
    if (sum && !friction.between) {
      sum = *sum + written(friction.wrench);
    }
  }
  solution.wrenches.clear();
  solution.wrenches.reserve(sums.size());
  solution.wrench_bounds.clear();
  solution.wrench_bounds.reserve(sums.size());
  for (const std::optional<BoundedWrench>& sum : sums) {
    solution.wrenches.push_back(sum ? std::optional(sum->zeroed()) : std::nullopt);
    solution.wrench_bounds.push_back(
        sum ? Wrench{.moment = sum->moment.bound, .force = sum->force.bound} : Wrench{});
  }
}

}  // namespace kinestat
