#include "cases/findings/bearing_pair.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "mechanism/gears/hinge_lines.hpp"

namespace kinestat {

namespace {

struct BearingActions {
  std::vector<std::string> radial;
  std::vector<std::string> forces;  ///< these, and what acts along the axis
  bool has_open_couple = false;
  bool has_open_thrust = false;
};

BearingActions actions_of(const Mechanism& mechanism,
                          const CouplingTopology& bearing,
                          const Vec3& axis,
                          const std::vector<int>& open) {
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
  const Topology& topology = mechanism.topology;
  for (const HingeLine& line : find_hinge_lines(topology, mechanism.geometry)) {
    std::map<std::pair<int, int>, std::vector<CouplingId>> bearings;  // of each two bodies
    for (const CouplingId hinge : line.hinges) {
      const CouplingTopology& one = topology.coupling(hinge);
      if (!actions_of(mechanism, one, line.direction, open).radial.empty()) {  // no clutch
        bearings[std::minmax(one.tail.value, one.head.value)].push_back(hinge);
      }
    }
    for (const auto& [bodies, pair] : bearings) {
      if (pair.size() != 2) {
        continue;  // of three bearings this leaves one too many
      }
      const CouplingTopology& first = topology.coupling(pair.front());
      const CouplingTopology& second = topology.coupling(pair.back());
      const BearingActions locating = actions_of(mechanism, first, line.direction, open);
      const BearingActions floating = actions_of(mechanism, second, line.direction, open);
      const bool has_open_couple = locating.has_open_couple || floating.has_open_couple;
      if (has_open_couple || (locating.has_open_thrust && floating.has_open_thrust)) {
        return fmt::format(
            "two bearings of one shaft: let '{}' carry passive: [{}] and '{}' passive: [{}]; "
            "'passive' lists what a bearing carries",
            first.name,
            fmt::join(locating.forces, ", "),
            second.name,
            fmt::join(floating.radial, ", "));
      }
    }
  }
  return {};
}

}  // namespace kinestat
