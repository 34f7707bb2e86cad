#include "statics/converter_state.hpp"

#include <algorithm>

#include "statics/friction_law.hpp"

namespace kinestat {

std::optional<double> ConverterState::efficiency() const {
  const double in = pump_torque * pump_speed;
  const double out = turbine_torque * turbine_speed;
  if (in == 0.0) {
    return std::nullopt;
  }
  return in < 0.0 ? in / out : std::max(0.0, out / in);
}

std::vector<ConverterState> find_converter_states(const Mechanism& mechanism,
                                                  const KinematicSolution& motion) {
  std::vector<ConverterState> states;
  for (const CouplingFriction& friction : mechanism.frictions) {
    if (!friction.converter || friction.converter->is_of_stator) {
      continue;
    }
    const auto [pump, turbine] = converter_turns(mechanism, motion, friction);
    const std::optional<ConverterPoint> point = friction.converter->point(pump, turbine);
    if (!point) {
      continue;
    }
    const double torque = pump < 0.0 ? -point->pump_torque : point->pump_torque;
    ConverterState state{.coupling = friction.coupling,
                         .pump_speed = pump,
                         .turbine_speed = turbine,
                         .torque_ratio = point->torque_ratio,
                         .pump_torque = torque,
                         .turbine_torque = point->torque_ratio * torque,
                         .stator_torque = (point->torque_ratio - 1.0) * torque,
                         .lost = torque * (pump - point->torque_ratio * turbine)};
    if (pump != 0.0) {
      state.speed_ratio = point->speed_ratio;
    }
    states.push_back(state);
  }
  return states;
}

}  // namespace kinestat
