// A planetary set with a clutch and a brake, and its plan.
#pragma once

#include <string>

#include "network/bases.hpp"
#include "studies/shift/shift_state.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {

/// Sun 30, planets 20, ring 70; the brake B holds the ring (ratio 1 + 70/30), the clutch C joins
/// ring and sun (ratio 1). `more` is further couplings, each on its line.
inline std::string two_speed_text(const std::string& more = {}) {
  return R"(
space: planar
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  s: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  r: {type: revolute, bodies: [housing, ring], at: [0, 0]}
  c: {type: revolute, bodies: [housing, carrier], at: [0, 0]}
  p: {type: revolute, bodies: [carrier, planet], at: [0, 25]}
  sp: {type: gear, bodies: [sun, planet], at: [0, 15], line_of_action: [-cos(20 deg), sin(20 deg)]}
  rp: {type: gear, bodies: [ring, planet], at: [0, 35], line_of_action: [-cos(20 deg), -sin(20 deg)], internal: true}
  C: {type: clutch, bodies: [sun, ring], at: [0, 0]}
  B: {type: brake, bodies: [housing, ring], at: [0, 0]}
)" + more +
         "actuators: {in: {coupling: s}, out: {coupling: c}}\n";
}

/// The index of an actuator; a failed test and -1 if there is none.
inline int actuator_index(const Mechanism& mechanism, const std::string& name) {
  const auto& actuators = mechanism.topology.actuators;
  const auto at = std::ranges::find(actuators, name, &ActuatorTopology::name);
  EXPECT_NE(at, actuators.end()) << name;
  return at == actuators.end() ? -1 : static_cast<int>(at - actuators.begin());
}

inline ShiftInput shift_input(const Mechanism& mechanism,
                              const std::string& name,
                              double speed,
                              std::optional<double> action) {
  return {.actuator = actuator_index(mechanism, name), .speed = speed, .action = action};
}

/// From `in` at 10 rad/s under 3 N·m to `out`.
inline ShiftPlan plan_of(const Mechanism& mechanism, const std::vector<std::string>& elements) {
  ShiftPlan plan;
  plan.inputs.push_back(shift_input(mechanism, "in", 10.0, 3.0));
  plan.outputs.push_back(actuator_index(mechanism, "out"));
  for (const std::string& name : elements) {
    plan.elements.push_back({.actuator = actuator_index(mechanism, name), .one_way = 0});
  }
  plan.asks_actions = true;
  return plan;
}

inline ShiftNetwork network_of(const Mechanism& mechanism, const ShiftPlan& plan) {
  return make_shift_network(
      mechanism, motion_basis(mechanism.geometry, mechanism.kinematic_order), plan);
}

}  // namespace kinestat
