#include "studies/tolerance/deviation.hpp"

#include <numeric>

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

// The first segment of the rope to which each coupling belongs: what slips on pulleys has one
// length.
std::vector<int> ropes_of(const Mechanism& mechanism) {
  std::vector<int> first(mechanism.topology.couplings.size());
  std::iota(first.begin(), first.end(), 0);
  const auto rope_of = [&](CouplingId segment) {
    int rope = segment.value;
    while (first[static_cast<std::size_t>(rope)] != rope) {
      rope = first[static_cast<std::size_t>(rope)];
    }
    return rope;
  };
  for (const CableContact& contact : mechanism.contacts) {
    if (contact.slips) {
      const int before = rope_of(contact.arrives);
      first[static_cast<std::size_t>(rope_of(contact.leaves))] = before;
    }
  }
  return first;
}

}  // namespace

std::vector<Deviation> part_deviations(const Mechanism& mechanism) {
  std::vector<Deviation> result;
  const std::vector<int> ropes = ropes_of(mechanism);
  for (int a = 0; a < mechanism.topology.action_count(); ++a) {
    const ActionLabel& label = mechanism.topology.actions[static_cast<std::size_t>(a)];
    const int coupling = label.coupling.value;
    if (label.actuator < 0) {
      result.push_back(deviation_of(mechanism, a));
      result.back().is_counted = ropes[static_cast<std::size_t>(coupling)] == coupling;
    }
  }
  return result;
}

}  // namespace kinestat
