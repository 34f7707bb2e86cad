#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "core/index.hpp"
#include "couplings/cable_geometry.hpp"
#include "mechanism/couplings/moved_coupling.hpp"
#include "studies/motion/task/position_findings.hpp"

namespace kinestat {

namespace {

// A station of a cable, and whether the file says that its cable may cross itself there.
struct DrawnPulley {
  const CableDescription* cable = nullptr;
  const CableStation* station = nullptr;
  bool may_cross = true;
};

DrawnPulley pulley_of(const MechanismDescription& description, const CableContact& contact) {
  for (const CableDescription& cable : description.cables) {
    const auto station = std::ranges::find(cable.over, contact.where, &CableStation::where);
    if (station != cable.over.end()) {
      return {.cable = &cable,
              .station = &*station,
              .may_cross = station->turns || cable.over.size() == 2};
    }
  }
  return {};
}

}  // namespace

void add_crossing_cables(const MechanismDescription& description,
                         const Mechanism& mechanism,
                         const FoundMotion& motion,
                         const Configuration& configuration,
                         std::span<const BodyPose> poses,
                         CaseFindings& found) {
  const auto length_of = [&](CouplingId segment) {
    const CouplingTopology& coupling = mechanism.topology.coupling(segment);
    const DrawnCoupling& drawn = motion.drawn[at(segment.value)];
    const CableSpan span =
        tangent_span<double>(moved_station(*drawn.from, poses[at(coupling.tail.value)]),
                             moved_station(*drawn.to, poses[at(coupling.head.value)]));
    return (span.to - span.from).norm();
  };
  const std::vector<double> arcs = contact_arcs(motion.network, configuration);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const CableContact& contact = mechanism.contacts[at(motion.network.arcs[i].contact)];
    const double shorter = std::min(length_of(contact.arrives), length_of(contact.leaves));
    if (!crosses_itself(contact.radius, arcs[i], shorter)) {
      continue;
    }
    const DrawnPulley pulley = pulley_of(description, contact);
    if (pulley.may_cross) {
      continue;
    }
    CaseFinding& one = found.warning(
        "W0308",
        contact.where,
        fmt::format("cable '{}' turns by {:.6g} deg about pulley '{}' and crosses itself",
                    pulley.cable->name.text,
                    arcs[i] * 180.0 / std::numbers::pi,
                    pulley.station->body.text),
        "end the motion earlier, or write 'turns: 0' at the pulley if it is meant");
    one.element = fmt::format("pulley '{}'", pulley.station->body.text);
    one.size = arcs[i];
  }
}

}  // namespace kinestat
