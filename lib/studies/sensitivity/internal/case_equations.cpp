#include "studies/sensitivity/internal/case_equations.hpp"

#include <utility>
#include <vector>

#include "network/node_system.hpp"

namespace kinestat {

FactoredSide motion_equations(const Mechanism& mechanism,
                              const Case& which,
                              const CoordinateBasis& basis) {
  const Topology& topology = mechanism.topology;
  std::vector<double> units;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    units.push_back(rate_unit(topology, basis, f));
  }
  return {basis,
          velocity_system(topology, mechanism.geometry, basis),
          which.motions,
          velocity_column(topology, basis, 0),
          std::move(units)};
}

FactoredSide action_equations(const Mechanism& mechanism,
                              const Case& which,
                              const CoordinateBasis& basis) {
  const Topology& topology = mechanism.topology;
  std::vector<double> units;
  for (int a = 0; a < topology.action_count(); ++a) {
    units.push_back(action_unit(topology, basis, a));
  }
  return {basis,
          action_system(topology, mechanism.geometry, basis),
          which.actions,
          0,
          std::move(units)};
}

}  // namespace kinestat
