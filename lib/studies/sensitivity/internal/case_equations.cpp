#include "studies/sensitivity/internal/case_equations.hpp"

#include "network/node_system.hpp"

namespace kinestat {

FactoredSide motion_equations(const Mechanism& mechanism,
                              const Case& which,
                              const CoordinateBasis& basis) {
  const Topology& topology = mechanism.topology;
  return {basis,
          velocity_system(topology, mechanism.geometry, basis),
          which.motions,
          velocity_column(topology, basis, 0),
          rate_units(topology, basis)};
}

FactoredSide action_equations(const Mechanism& mechanism,
                              const Case& which,
                              const CoordinateBasis& basis) {
  const Topology& topology = mechanism.topology;
  return {basis,
          action_system(topology, mechanism.geometry, basis),
          which.actions,
          0,
          action_units(topology, basis)};
}

}  // namespace kinestat
