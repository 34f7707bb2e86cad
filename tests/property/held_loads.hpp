// Random loads that a network can hold.
#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "support/random.hpp"

namespace kinestat {

/// Those that are in equilibrium with random actions, of which nothing else is known. On the ground
/// too, where they must not count.
struct HeldLoads {
  VecX held_by;  ///< magnitudes of actions that hold the loads
  std::vector<BodyWrench> loads;
};

inline HeldLoads make_held_loads(const Mechanism& mechanism, Random& random) {
  HeldLoads result{.held_by = VecX(mechanism.topology.action_count()), .loads = {}};
  for (double& magnitude : result.held_by) {
    magnitude = random.magnitude();
  }
  for (int a = 0; a < mechanism.topology.action_count(); ++a) {
    const ActionLabel& label = mechanism.topology.actions[static_cast<std::size_t>(a)];
    const CouplingTopology& coupling = mechanism.topology.coupling(label.coupling);
    const Wrench wrench =
        result.held_by[a] * mechanism.geometry.actions[static_cast<std::size_t>(a)];
    result.loads.push_back({.body = coupling.head, .wrench = -1.0 * wrench});
    result.loads.push_back({.body = coupling.tail, .wrench = wrench});
  }
  return result;
}

}  // namespace kinestat
