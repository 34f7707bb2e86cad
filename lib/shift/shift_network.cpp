#include "shift/shift_network.hpp"

#include <vector>

#include "math/elimination.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// The rates of actuators in each motion.
MatX rates_of(const Mechanism& mechanism,
              const CoordinateBasis& basis,
              const std::vector<int>& actuators,
              const std::vector<VecX>& motions) {
  const Topology& topology = mechanism.topology;
  MatX rates(static_cast<Eigen::Index>(actuators.size()),
             static_cast<Eigen::Index>(motions.size()));
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const int freedom = topology.actuators[static_cast<std::size_t>(actuators[i])].freedom;
    const int column = velocity_column(topology, basis, freedom);
    const double unit = rate_unit(topology, basis, freedom);
    for (std::size_t j = 0; j < motions.size(); ++j) {
      rates(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = unit * motions[j][column];
    }
  }
  return rates;
}

template <class List, class Projection>
std::vector<int> actuators_of(const List& list, Projection actuator) {
  std::vector<int> actuators;
  for (const auto& one : list) {
    actuators.push_back(one.*actuator);
  }
  return actuators;
}

}  // namespace

ShiftNetwork make_shift_network(const Mechanism& mechanism,
                                const CoordinateBasis& basis,
                                const ShiftPlan& plan) {
  const Elimination elimination(velocity_system(mechanism.topology, mechanism.geometry, basis), {});
  const std::vector<VecX> motions = elimination.null_vectors();
  const auto rates = [&](const std::vector<int>& actuators) {
    return rates_of(mechanism, basis, actuators, motions);
  };
  ShiftNetwork network{.inputs = rates(actuators_of(plan.inputs, &ShiftInput::actuator)),
                       .outputs = rates(plan.outputs),
                       .elements = rates(actuators_of(plan.elements, &ShiftElement::actuator)),
                       .others = rates(plan.others),
                       .bodies = {},
                       .order = basis.order()};
  const Eigen::Index rows = basis.order() * (mechanism.topology.body_count() - 1);
  network.bodies.resize(rows, static_cast<Eigen::Index>(motions.size()));
  for (std::size_t j = 0; j < motions.size(); ++j) {
    network.bodies.col(static_cast<Eigen::Index>(j)) = motions[j].head(rows);
  }
  return network;
}

}  // namespace kinestat
