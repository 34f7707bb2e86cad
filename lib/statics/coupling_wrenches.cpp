#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

std::optional<Wrench> sum_of_actions(const CouplingTopology& coupling,
                                     const Geometry& geometry,
                                     const StaticSolution& solution) {
  Wrench sum;
  for (int i = coupling.first_action; i < coupling.first_action + coupling.action_count; ++i) {
    const auto a = static_cast<std::size_t>(i);
    if (!solution.magnitudes[a]) {
      return std::nullopt;
    }
    sum = sum + *solution.magnitudes[a] * geometry.actions[a];
  }
  return sum;
}

}  // namespace

std::vector<std::optional<Wrench>> coupling_wrenches(const Mechanism& mechanism,
                                                     const StaticSolution& solution) {
  std::vector<std::optional<Wrench>> wrenches;
  wrenches.reserve(mechanism.topology.couplings.size());
  for (const CouplingTopology& coupling : mechanism.topology.couplings) {
    wrenches.push_back(sum_of_actions(coupling, mechanism.geometry, solution));
  }
  for (const FrictionAction& friction : solution.friction) {
    std::optional<Wrench>& wrench = wrenches[static_cast<std::size_t>(friction.coupling.value)];
    if (wrench) {
      wrench = *wrench + friction.wrench;
    }
  }
  return wrenches;
}

}  // namespace kinestat
