#include "mechanism/check/link_length_check.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Whether two turns are about one line; `length` is the size of the mechanism.
bool are_coaxial(const Twist& one, const Twist& other, double length) {
  const double sense = one.angular.dot(other.angular) < 0.0 ? -1.0 : 1.0;
  const Vec3 turn = one.angular - sense * other.angular;
  const Vec3 slide = one.linear - sense * other.linear;
  return turn.norm() <= kParallelAxes && slide.norm() <= kSameValue * length;
}

// Whether the coupling lets a cable slip on a pulley, which is no bar.
bool slips(const Mechanism& mechanism, const CouplingTopology& coupling) {
  return std::ranges::any_of(mechanism.contacts, [&](const CableContact& contact) {
    return contact.slips && &mechanism.topology.coupling(*contact.slips) == &coupling;
  });
}

}  // namespace

void warn_of_links_without_length(const Mechanism& mechanism, Diagnostics& found) {
  const Topology& topology = mechanism.topology;
  std::vector<std::vector<const CouplingTopology*>> joined(topology.bodies.size());
  for (const CouplingTopology& coupling : topology.couplings) {
    joined[static_cast<std::size_t>(coupling.tail.value)].push_back(&coupling);
    joined[static_cast<std::size_t>(coupling.head.value)].push_back(&coupling);
  }
  for (std::size_t b = 1; b < joined.size(); ++b) {
    const bool is_bar =
        joined[b].size() == 2 && std::ranges::all_of(joined[b], [&](const CouplingTopology* one) {
          return one->type == CouplingType::revolute && !slips(mechanism, *one);
        });
    const auto motion = [&](std::size_t i) {
      return mechanism.geometry.motions[static_cast<std::size_t>(joined[b][i]->first_freedom)];
    };
    if (is_bar && are_coaxial(motion(0), motion(1), mechanism.geometry.length)) {
      found.warning(
          "W0309",
          topology.bodies[b].where,
          fmt::format("link '{}' has no length: its couplings '{}' and '{}' have one axis",
                      topology.bodies[b].name,
                      joined[b][0]->name,
                      joined[b][1]->name),
          "give the two couplings different points, or join their other bodies directly");
    }
  }
}

}  // namespace kinestat
