#include "mechanism/couplings/freewheel.hpp"

namespace kinestat {

std::optional<FreewheelFault> fault_of(const Freewheel& freewheel, double torque, double slip) {
  if (freewheel.holds * torque < 0.0) {
    return FreewheelFault::overruns;
  }
  return freewheel.holds * slip < 0.0 ? std::optional(FreewheelFault::locks) : std::nullopt;
}

std::vector<Freewheel> bind_freewheels(const MechanismDescription& description,
                                       const Topology& topology) {
  std::vector<Freewheel> all;
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    const std::optional<OneWay>& holds = description.couplings[e].one_way;
    const CouplingId id{static_cast<int>(e)};
    for (const ActuatorTopology& actuator : topology.actuators) {
      if (holds && topology.freedoms[static_cast<std::size_t>(actuator.freedom)].coupling == id) {
        all.push_back({.coupling = id,
                       .action = actuator.action,
                       .freedom = actuator.freedom,
                       .holds = *holds == OneWay::positive ? 1 : -1});
      }
    }
  }
  return all;
}

}  // namespace kinestat
