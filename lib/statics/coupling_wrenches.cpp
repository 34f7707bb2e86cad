#include "statics/coupling_wrenches.hpp"

#include <cmath>

#include "core/rounding.hpp"
#include "screw/bounded_screw_sum.hpp"

namespace kinestat {

namespace {

void put(const BoundedWrench& wrench, std::size_t e, StaticSolution& solution) {
  solution.wrenches[e] = Wrench{.moment = wrench.moment.value, .force = wrench.force.value};
  solution.wrench_bounds[e] = {.moment = wrench.moment.bound, .force = wrench.force.bound};
}

// Nothing where one of the actions is open.
void sum_actions(const Mechanism& mechanism, std::size_t e, StaticSolution& solution) {
  const CouplingTopology& coupling = mechanism.topology.couplings[e];
  const Geometry& geometry = mechanism.geometry;
  const Vec3 at = geometry.points[e];
  BoundedScrewSum sum(at);
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    const auto i = static_cast<std::size_t>(a);
    if (!solution.magnitudes[i]) {
      return;
    }
    const Wrench& unit = geometry.actions[i];
    sum.add(bounded_action(solution, a), unit.force, unit.moment);
  }
  put({.moment = sum.moment(), .force = sum.line()}, e, solution);
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
  const std::size_t count = mechanism.topology.couplings.size();
  solution.wrenches.assign(count, std::nullopt);
  solution.wrench_bounds.assign(count, Wrench{});
  for (std::size_t e = 0; e < count; ++e) {
    sum_actions(mechanism, e, solution);
  }
  for (const FrictionAction& friction : solution.friction) {
    const auto e = static_cast<std::size_t>(friction.coupling.value);
    if (const auto sum = bounded_wrench(solution, friction.coupling); sum && !friction.between) {
      put(*sum + written(friction.wrench), e, solution);
    }
  }
  for (std::size_t e = 0; e < count; ++e) {
    if (std::optional<Wrench>& wrench = solution.wrenches[e]) {
      settle(solution.wrench_bounds[e].moment, wrench->moment);
      settle(solution.wrench_bounds[e].force, wrench->force);
    }
  }
}

}  // namespace kinestat
