#include "power/net_shafts.hpp"

#include <algorithm>

#include "couplings/kinds.hpp"

namespace kinestat {

NetShafts::NetShafts(const Topology& topology, std::span<const Mesh> meshes) : topology_(topology) {
  for (int b = 0; b < topology_.body_count(); ++b) {
    shaft_of_.push_back(BodyId{b});
  }
  carrier_of_.resize(topology_.bodies.size());
  for (const Mesh& mesh : meshes) {
    find_planets(mesh);
  }
  for (const Mesh& mesh : meshes) {
    join_planets(mesh);
  }
}

std::optional<BodyId> NetShafts::planet_on(CouplingId id) const {
  const CouplingTopology& coupling = topology_.coupling(id);
  if (carrier_of(coupling.head) == coupling.tail) {
    return coupling.head;
  }
  return carrier_of(coupling.tail) == coupling.head ? std::optional(coupling.tail) : std::nullopt;
}

bool NetShafts::is_summed(CouplingId id) const {
  return topology_.coupling(id).type == CouplingType::cable || bears_planet(id);
}

bool NetShafts::turns_on(BodyId gear, BodyId carrier) const {
  return std::ranges::all_of(topology_.couplings, [&](const CouplingTopology& coupling) {
    const bool is_at = coupling.tail == gear || coupling.head == gear;
    const BodyId other = coupling.tail == gear ? coupling.head : coupling.tail;
    return !is_at || joins_wheels(coupling.type) || other == carrier;
  });
}

void NetShafts::find_planets(const Mesh& mesh) {
  if (!mesh.carrier || mesh.carrier->value == 0) {
    return;
  }
  const CouplingTopology& teeth = topology_.coupling(mesh.coupling);
  for (const BodyId gear : {teeth.tail, teeth.head}) {
    if (turns_on(gear, *mesh.carrier)) {
      carrier_of_[index(gear)] = mesh.carrier;
    }
  }
}

void NetShafts::join_planets(const Mesh& mesh) {
  const CouplingTopology& teeth = topology_.coupling(mesh.coupling);
  if (!carrier_of(teeth.tail) || carrier_of(teeth.tail) != carrier_of(teeth.head)) {
    return;
  }
  const BodyId tail = shaft_of(teeth.tail);
  const BodyId head = shaft_of(teeth.head);
  std::ranges::replace(shaft_of_, std::max(tail, head), std::min(tail, head));
}

}  // namespace kinestat
