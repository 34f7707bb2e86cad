#include "mechanism/gears/internal/planet_set.hpp"

#include <algorithm>
#include <cmath>

#include "description/gear_expansion.hpp"

namespace kinestat {

namespace {

const GearMember* find_counted(const GearsDescription& gears, const GearAxis& planet) {
  for (const int m : planet.members) {
    const GearMember& member = gears.members[static_cast<std::size_t>(m)];
    if (member.count) {
      return &member;
    }
  }
  return nullptr;
}

// Of each body of the topology.
std::vector<int> counts_of_bodies(const MechanismDescription& description,
                                  const Topology& topology,
                                  Evaluator& evaluator) {
  std::vector<int> counts(topology.bodies.size(), 1);
  const GearTrain train = find_gear_train(description);
  for (const PlanetSet& set : bind_planet_sets(*description.gears, train, evaluator)) {
    for (const int p : set.planets) {
      for (const std::string& body : train.axes[static_cast<std::size_t>(p)].bodies) {
        for (std::size_t b = 0; b < counts.size(); ++b) {
          counts[b] = topology.bodies[b].name == body ? set.count : counts[b];
        }
      }
    }
  }
  return counts;
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
      set.counted = find_counted(gears, train.axes[p]);
    }
  }
  for (PlanetSet& set : sets) {
    const auto count = set.counted == nullptr
                           ? std::nullopt
                           : evaluator.number(*set.counted->count, QuantityKind::dimensionless);
    set.count = static_cast<int>(std::lround(count.value_or(1.0)));
  }
  return sets;
}

std::vector<int> bind_planet_counts(const MechanismDescription& description,
                                    const Topology& topology,
                                    Evaluator& evaluator) {
  std::vector<int> result(topology.actions.size(), 1);
  if (!description.gears || !has_all_meshes(description)) {
    return result;
  }
  const std::vector<int> counts = counts_of_bodies(description, topology, evaluator);
  for (std::size_t a = 0; a < result.size(); ++a) {
    const CouplingTopology& coupling = topology.coupling(topology.actions[a].coupling);
    const int tail = counts[static_cast<std::size_t>(coupling.tail.value)];
    const int head = counts[static_cast<std::size_t>(coupling.head.value)];
    result[a] = std::max(tail, head);
  }
  return result;
}

}  // namespace kinestat
