#include "cases/bearing_pair.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

namespace {

bool is_bearing(const CouplingTopology& one) {
  return one.type == CouplingType::revolute || one.type == CouplingType::cylindrical;
}

ScrewAxis axis_of(const Mechanism& mechanism, const CouplingTopology& bearing) {
  return *find_axis(mechanism.geometry.motions[static_cast<std::size_t>(bearing.first_freedom)],
                    1.0);
}

// Whether they bear the same two bodies about the same axis.
bool are_on_one_shaft(const Mechanism& mechanism,
                      const CouplingTopology& one,
                      const CouplingTopology& other) {
  if (std::minmax(one.tail.value, one.head.value) !=
      std::minmax(other.tail.value, other.head.value)) {
    return false;
  }
  const ScrewAxis first = axis_of(mechanism, one);
  const ScrewAxis second = axis_of(mechanism, other);
  return first.direction.cross(second.direction).norm() <= kRankZero &&
         (*first.point - *second.point).norm() <= kRankZero * mechanism.geometry.length;
}

struct BearingActions {
  std::vector<std::string> radial;
  std::vector<std::string> forces;  ///< these, and what acts along the axis
  bool has_open_couple = false;
  bool has_open_thrust = false;
};

BearingActions actions_of(const Mechanism& mechanism,
                          const CouplingTopology& bearing,
                          const std::vector<int>& open) {
  const Vec3 axis = axis_of(mechanism, bearing).direction;
  BearingActions found;
  for (int a = bearing.first_action; a < bearing.first_action + bearing.action_count; ++a) {
    const ActionLabel& label = mechanism.topology.actions[static_cast<std::size_t>(a)];
    const bool is_open = std::ranges::find(open, a) != open.end();
    if (label.actuator >= 0) {
      continue;
    }
    if (label.is_couple) {
      found.has_open_couple = found.has_open_couple || is_open;
      continue;
    }
    const Vec3& force = mechanism.geometry.actions[static_cast<std::size_t>(a)].force;
    const bool is_radial = std::abs(axis.dot(force)) <= kRankZero;
    found.forces.push_back(label.name);
    if (is_radial) {
      found.radial.push_back(label.name);
    }
    found.has_open_thrust = found.has_open_thrust || (is_open && !is_radial);
  }
  return found;
}

}  // namespace

std::string bearing_pair_hint(const Mechanism& mechanism, const std::vector<int>& open) {
  const std::vector<CouplingTopology>& couplings = mechanism.topology.couplings;
  for (const CouplingTopology& first : couplings) {
    std::vector<const CouplingTopology*> others;
    for (const CouplingTopology& other : couplings) {
      if (&other != &first && is_bearing(first) && is_bearing(other) &&
          are_on_one_shaft(mechanism, first, other)) {
        others.push_back(&other);
      }
    }
    if (others.size() != 1) {
      continue;  // of three bearings this leaves one too many
    }
    const BearingActions locating = actions_of(mechanism, first, open);
    const BearingActions floating = actions_of(mechanism, *others.front(), open);
    if (!locating.has_open_couple && !floating.has_open_couple &&
        !(locating.has_open_thrust && floating.has_open_thrust)) {
      continue;
    }
    return fmt::format(
        "two bearings of one shaft: let '{}' carry passive: [{}] and '{}' passive: [{}]; 'passive' "
        "lists what a bearing carries",
        first.name,
        fmt::join(locating.forces, ", "),
        others.front()->name,
        fmt::join(floating.radial, ", "));
  }
  return {};
}

}  // namespace kinestat
