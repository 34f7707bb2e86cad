#include "mechanism/duty/duty_point.hpp"

#include <algorithm>

namespace kinestat {

namespace {

std::vector<double> magnitudes_of(const std::vector<Primary>& primaries) {
  std::vector<double> values;
  for (const Primary& primary : primaries) {
    values.push_back(primary.value);
  }
  return values;
}

}  // namespace

DutyPoint point_of(const Mechanism& mechanism, std::size_t which) {
  return {.which = which,
          .motions = magnitudes_of(mechanism.cases[which].motions),
          .actions = magnitudes_of(mechanism.cases[which].actions)};
}

std::optional<std::size_t> find_known(const Mechanism& mechanism,
                                      std::size_t which,
                                      std::size_t actuator,
                                      DutySide side) {
  const ActuatorTopology& one = mechanism.topology.actuators[actuator];
  const bool is_motion = side == DutySide::motion;
  const Case& of = mechanism.cases[which];
  const std::vector<Primary>& known = is_motion ? of.motions : of.actions;
  const auto at = std::ranges::find(known, is_motion ? one.freedom : one.action, &Primary::index);
  return at == known.end() ? std::nullopt
                           : std::optional(static_cast<std::size_t>(at - known.begin()));
}

}  // namespace kinestat
