#include "report/ratio_in_units.hpp"

namespace kinestat {

namespace {

RatioInUnits converted(const std::optional<double>& value,
                       QuantityKind input,
                       QuantityKind output,
                       const FileUnits& units) {
  RatioInUnits result;
  if (value) {
    result.value = input == output ? *value : *value * units.factor(output) / units.factor(input);
  }
  if (input != output) {
    result.unit = units.text(input) + " per " + units.text(output);
  }
  return result;
}

bool turns(const Mechanism& mechanism, int actuator) {
  const int freedom = mechanism.topology.actuators[static_cast<std::size_t>(actuator)].freedom;
  return mechanism.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation;
}

}  // namespace

RatioInUnits ratio_in_units(const CaseAnalysis& one,
                            const Mechanism& mechanism,
                            const FileUnits& units) {
  const auto kind = [&](int actuator) {
    return turns(mechanism, actuator) ? QuantityKind::angular_velocity : QuantityKind::velocity;
  };
  return converted(
      one.ratios->ratio, kind(one.which.inputs.front()), kind(one.which.outputs.front()), units);
}

RatioInUnits torque_ratio_in_units(const CaseAnalysis& one,
                                   const Mechanism& mechanism,
                                   const FileUnits& units) {
  const auto kind = [&](int actuator) {
    return turns(mechanism, actuator) ? QuantityKind::moment : QuantityKind::force;
  };
  return converted(one.ratios->torque_ratio,
                   kind(one.which.inputs.front()),
                   kind(one.which.outputs.front()),
                   units);
}

}  // namespace kinestat
