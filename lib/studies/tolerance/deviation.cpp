#include "studies/tolerance/deviation.hpp"

namespace kinestat {

namespace {

Deviation deviation_of(const Mechanism& mechanism, int action) {
  const auto a = static_cast<std::size_t>(action);
  const ActionLabel& label = mechanism.topology.actions[a];
  const Wrench& unit = mechanism.geometry.actions[a];
  Deviation result{.action = action, .is_angle = label.is_couple, .direction = {}, .unit = {}};
  result.direction = (label.is_couple ? unit.moment : unit.force).normalized();
  const Vec3& at = mechanism.geometry.points[static_cast<std::size_t>(label.coupling.value)];
  result.unit =
      label.is_couple ? unit_rotation(result.direction, at) : unit_translation(result.direction);
  return result;
}

}  // namespace

std::vector<Deviation> part_deviations(const Mechanism& mechanism) {
  std::vector<Deviation> result;
  for (int a = 0; a < mechanism.topology.action_count(); ++a) {
    if (mechanism.topology.actions[static_cast<std::size_t>(a)].actuator < 0) {
      result.push_back(deviation_of(mechanism, a));
    }
  }
  return result;
}

}  // namespace kinestat
