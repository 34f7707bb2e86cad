#include "mechanism/dynamics_plan.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "mechanism/bind/evaluator.hpp"

namespace kinestat {

namespace {

template <class Item>
int index_of(const std::vector<Item>& items, const Name& name) {
  const auto at = std::ranges::find(items, name.text, &Item::name);
  KINESTAT_EXPECTS(at != items.end());
  return static_cast<int>(at - items.begin());
}

}  // namespace

std::optional<DynamicsPlan> bind_dynamics(const MechanismDescription& description,
                                          const Mechanism& mechanism) {
  if (!description.dynamics) {
    return std::nullopt;
  }
  const DynamicsDescription& dynamics = *description.dynamics;
  const Topology& topology = mechanism.topology;
  Diagnostics ignored;
  Evaluator evaluator = make_evaluator(description, ignored);
  DynamicsPlan plan;
  plan.where = dynamics.where;
  for (const Name& actuator : dynamics.actuators) {
    plan.actuators.push_back(
        {.actuator = index_of(topology.actuators, actuator), .where = actuator.where});
  }
  if (dynamics.flywheel) {
    const FlywheelDescription& one = *dynamics.flywheel;
    plan.flywheel = {
        .actuator = index_of(topology.actuators, one.at),
        .fluctuation = evaluator.number(one.fluctuation, QuantityKind::dimensionless).value_or(0.0),
        .where = one.at.where};
  }
  if (dynamics.harmonics) {
    const auto orders = evaluator.number(*dynamics.harmonics, QuantityKind::dimensionless);
    plan.harmonics = static_cast<int>(std::lround(orders.value_or(0.0)));
  }
  if (dynamics.balance) {
    for (const Name& body : dynamics.balance->bodies) {
      plan.counterweights.push_back(
          {.body = {index_of(topology.bodies, body)}, .where = body.where});
    }
  }
  for (const Name& coupling : dynamics.limit_speed) {
    plan.limited.push_back(
        {.coupling = {index_of(topology.couplings, coupling)}, .where = coupling.where});
  }
  KINESTAT_EXPECTS(!ignored.has_errors());
  return plan;
}

}  // namespace kinestat
