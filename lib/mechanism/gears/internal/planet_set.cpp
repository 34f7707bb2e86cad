#include "mechanism/gears/internal/planet_set.hpp"

#include <algorithm>
#include <cmath>

#include "description/gear_expansion.hpp"

namespace kinestat {

namespace {

const GearMember* find_member_with(std::optional<Value> GearMember::*key,
                                   const GearsDescription& gears,
                                   const GearAxis& planet) {
  for (const int m : planet.members) {
    const GearMember& member = gears.members[static_cast<std::size_t>(m)];
    if (member.*key) {
      return &member;
    }
  }
  return nullptr;
}

// Of each body what it has as a planet, 1 of all others.
template <class T>
std::vector<T> of_bodies(T PlanetSet::*what,
                         const MechanismDescription& description,
                         const Topology& topology,
                         Evaluator& evaluator) {
  std::vector<T> of_body(topology.bodies.size(), T{1});
  if (!description.gears || !has_all_meshes(description)) {
    return of_body;
  }
  const GearTrain train = find_gear_train(description);
  for (const PlanetSet& set : bind_planet_sets(*description.gears, train, evaluator)) {
    for (const int p : set.planets) {
      for (const std::string& body : train.axes[static_cast<std::size_t>(p)].bodies) {
        for (std::size_t b = 0; b < of_body.size(); ++b) {
          of_body[b] = topology.bodies[b].name == body ? set.*what : of_body[b];
        }
      }
    }
  }
  return of_body;
}

// Of each action what its planets have, 1 of all others.
template <class T>
std::vector<T> of_actions(T PlanetSet::*what,
                          const MechanismDescription& description,
                          const Topology& topology,
                          Evaluator& evaluator) {
  const std::vector<T> of_body = of_bodies(what, description, topology, evaluator);
  std::vector<T> result(topology.actions.size(), T{1});
  for (std::size_t a = 0; a < result.size(); ++a) {
    const CouplingTopology& coupling = topology.coupling(topology.actions[a].coupling);
    result[a] = std::max(of_body[static_cast<std::size_t>(coupling.tail.value)],
                         of_body[static_cast<std::size_t>(coupling.head.value)]);
  }
  return result;
}

}  // namespace

std::vector<PlanetSet> bind_planet_sets(const GearsDescription& gears,
                                        const GearTrain& train,
                                        Evaluator& evaluator) {
  std::vector<PlanetSet> sets;
  for (std::size_t p = 0; p < train.axes.size(); ++p) {
    if (train.axes[p].neighbour < 0) {
      sets.emplace_back();
    }
    PlanetSet& set = sets.back();
    set.planets.push_back(static_cast<int>(p));
    if (set.counted == nullptr) {
      set.counted = find_member_with(&GearMember::count, gears, train.axes[p]);
    }
    if (set.shared == nullptr) {
      set.shared = find_member_with(&GearMember::load_sharing, gears, train.axes[p]);
    }
  }
  for (PlanetSet& set : sets) {
    const auto count = set.counted == nullptr
                           ? std::nullopt
                           : evaluator.number(*set.counted->count, QuantityKind::dimensionless);
    set.count = static_cast<int>(std::lround(count.value_or(1.0)));
    if (set.shared != nullptr) {
      set.load_sharing =
          evaluator.number(*set.shared->load_sharing, QuantityKind::dimensionless).value_or(1.0);
    }
  }
  return sets;
}

std::vector<int> bind_planet_counts(const MechanismDescription& description,
                                    const Topology& topology,
                                    Evaluator& evaluator) {
  return of_actions(&PlanetSet::count, description, topology, evaluator);
}

std::vector<int> bind_body_counts(const MechanismDescription& description,
                                  const Topology& topology,
                                  Evaluator& evaluator) {
  return of_bodies(&PlanetSet::count, description, topology, evaluator);
}

std::vector<double> bind_load_sharing(const MechanismDescription& description,
                                      const Topology& topology,
                                      Evaluator& evaluator) {
  return of_actions(&PlanetSet::load_sharing, description, topology, evaluator);
}

}  // namespace kinestat
