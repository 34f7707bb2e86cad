#include "mechanism/gears/planet_load.hpp"

#include <fmt/format.h>

#include "core/index.hpp"
#include "mechanism/gears/central_hinge.hpp"

namespace kinestat {

int planets_of(const Mechanism& mechanism, const CouplingTopology& coupling) {
  return has_planets(mechanism) && coupling.action_count > 0
             ? mechanism.planet_counts[at(coupling.first_action)]
             : 1;
}

double most_loaded_share(const Mechanism& mechanism, const CouplingTopology& coupling) {
  const int count = planets_of(mechanism, coupling);
  return count > 1 ? mechanism.load_sharing[at(coupling.first_action)] / count : 1.0;
}

void settle_planet_frictions(Mechanism& mechanism, Diagnostics& found) {
  const std::vector<std::optional<CentralHinge>> central = find_central_hinges(mechanism);
  for (CouplingFriction& friction : mechanism.frictions) {
    const CouplingTopology& coupling = mechanism.topology.coupling(friction.coupling);
    const std::optional<CentralHinge>& hinge = central[at(friction.coupling.value)];
    friction.planets = planets_of(mechanism, coupling);
    if (!hinge) {
      continue;
    }
    friction.is_balanced = hinge->across == CentralHinge::Across::nothing;
    friction.beside = hinge->planets;
    if (hinge->across == CentralHinge::Across::shared && friction.mu > 0.0) {
      found.warning("W0315",
                    friction.where,
                    fmt::format("the friction of '{}' counts radial forces of planets that cancel",
                                coupling.name),
                    "other bearings share what it bears, or planets have inertia beside other "
                    "loads, so that the planets' part is not known; give 'tau' in place of 'mu'");
    }
  }
}

}  // namespace kinestat
