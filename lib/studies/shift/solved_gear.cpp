#include "studies/shift/solved_gear.hpp"

namespace kinestat {

namespace {

const ActuatorTopology& actuator_of(const SolvedGear& gear, std::size_t element) {
  const int actuator = gear.plan.elements[element].actuator;
  return gear.mechanism.topology.actuators[static_cast<std::size_t>(actuator)];
}

}  // namespace

std::optional<double> slip_of(const SolvedGear& gear, std::size_t element) {
  const bool is_solved = gear.motion != nullptr && gear.motion->status == SolveStatus::solved;
  const auto freedom = static_cast<std::size_t>(actuator_of(gear, element).freedom);
  if (!is_solved) {
    return gear.state.slips[element];
  }
  return gear.motion->knows_rate(static_cast<int>(freedom))
             ? std::optional(gear.motion->rates[freedom])
             : std::nullopt;
}

std::optional<double> torque_of(const SolvedGear& gear, std::size_t element) {
  const auto action = static_cast<std::size_t>(actuator_of(gear, element).action);
  return gear.action != nullptr && !gear.action->magnitudes.empty()
             ? gear.action->magnitudes[action]
             : std::nullopt;
}

std::optional<double> lossy_torque_of(const SolvedGear& gear, std::size_t element) {
  const auto action = static_cast<std::size_t>(actuator_of(gear, element).action);
  return gear.lossy_actions != nullptr ? (*gear.lossy_actions)[action] : std::nullopt;
}

}  // namespace kinestat
