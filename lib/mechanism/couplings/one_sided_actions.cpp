#include "mechanism/couplings/one_sided_actions.hpp"

#include "couplings/kinds.hpp"

namespace kinestat {

std::vector<int> find_tensions(const Topology& topology) {
  std::vector<int> tensions;
  for (const CouplingTopology& coupling : topology.couplings) {
    if (coupling.bears_tension()) {
      tensions.push_back(coupling.first_action);
    }
  }
  return tensions;
}

std::vector<int> find_contact_forces(const Topology& topology) {
  std::vector<int> forces;
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    const ActionLabel& label = topology.actions[a];
    if (kind_of(topology.coupling(label.coupling).type).only_pushes && !label.is_couple &&
        label.actuator < 0) {
      forces.push_back(static_cast<int>(a));
    }
  }
  return forces;
}

}  // namespace kinestat
