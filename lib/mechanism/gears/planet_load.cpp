#include "mechanism/gears/planet_load.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/index.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/gears/hinge_lines.hpp"

namespace kinestat {

namespace {

// What acts on the bodies of a line beside its own hinges and what engages on it.
class ActsOnBodies {
 public:
  explicit ActsOnBodies(const Mechanism& mechanism)
      : mechanism_(mechanism),
        bears_planets_(mechanism.topology.bodies.size(), false),
        bears_load_(mechanism.topology.bodies.size(), false) {
    for (const CouplingTopology& coupling : mechanism.topology.couplings) {
      if (planets_of(mechanism, coupling) > 1) {
        bears_planets_[at(coupling.tail.value)] = true;
        bears_planets_[at(coupling.head.value)] = true;
      }
    }
    for (const Case& one : mechanism.cases) {
      for (const Load& load : one.loads) {
        bears_load_[at(load.acts.body.value)] = true;
      }
    }
  }

  // The ground may bear planets of other lines.
  bool bears_planets(const HingeLine& line) const {
    return std::ranges::any_of(line.bodies, [&](BodyId body) {
      return body.value != 0 && bears_planets_[at(body.value)];
    });
  }

  bool bears_more(const HingeLine& line) const {
    const auto is_on = [&](BodyId body) {
      return body.value != 0 &&
             std::ranges::binary_search(line.bodies, body.value, {}, &BodyId::value);
    };
    const auto& couplings = mechanism_.topology.couplings;
    for (std::size_t e = 0; e < couplings.size(); ++e) {
      const CouplingTopology& one = couplings[e];
      const bool is_known =
          planets_of(mechanism_, one) > 1 || kind_of(one.type).engages ||
          std::ranges::find(line.hinges, static_cast<int>(e), &CouplingId::value) !=
              line.hinges.end();
      if (!is_known && (is_on(one.tail) || is_on(one.head))) {
        return true;
      }
    }
    return std::ranges::any_of(
        line.bodies, [&](BodyId body) { return is_on(body) && bears_load_[at(body.value)]; });
  }

 private:
  const Mechanism& mechanism_;
  std::vector<bool> bears_planets_;
  std::vector<bool> bears_load_;
};

}  // namespace

int planets_of(const Mechanism& mechanism, const CouplingTopology& coupling) {
  return has_planets(mechanism) && coupling.action_count > 0
             ? mechanism.planet_counts[at(coupling.first_action)]
             : 1;
}

double most_loaded_share(const Mechanism& mechanism, const CouplingTopology& coupling) {
  const int count = planets_of(mechanism, coupling);
  return count > 1 ? mechanism.load_sharing[at(coupling.first_action)] / count : 1.0;
}

std::vector<std::optional<CentralHinge>> find_central_hinges(const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  std::vector<std::optional<CentralHinge>> found(topology.couplings.size());
  if (!has_planets(mechanism)) {
    return found;
  }
  const ActsOnBodies acts(mechanism);
  for (const HingeLine& line : find_hinge_lines(topology, mechanism.geometry)) {
    const bool is_of_planets = std::ranges::any_of(line.hinges, [&](CouplingId hinge) {
      return planets_of(mechanism, topology.coupling(hinge)) > 1;
    });
    if (!is_of_planets && acts.bears_planets(line)) {
      const bool bears_more = acts.bears_more(line);
      for (const CouplingId hinge : line.hinges) {
        found[at(hinge.value)] = {.axis = line.direction, .bears_more = bears_more};
      }
    }
  }
  return found;
}

void settle_planet_frictions(Mechanism& mechanism, Diagnostics& found) {
  const std::vector<std::optional<CentralHinge>> central = find_central_hinges(mechanism);
  for (CouplingFriction& friction : mechanism.frictions) {
    const CouplingTopology& coupling = mechanism.topology.coupling(friction.coupling);
    const std::optional<CentralHinge>& hinge = central[at(friction.coupling.value)];
    friction.planets = planets_of(mechanism, coupling);
    friction.is_balanced = hinge && !hinge->bears_more;
    if (hinge && hinge->bears_more && friction.mu > 0.0) {
      found.warning("W0315",
                    friction.where,
                    fmt::format("the friction of '{}' counts radial forces of planets that cancel",
                                coupling.name),
                    "loads or other meshes press it too, and the planets' part is not taken out of "
                    "that: one planet is drawn in the place of all; give 'tau' in place of 'mu'");
    }
  }
}

}  // namespace kinestat
