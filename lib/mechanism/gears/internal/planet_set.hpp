// Planets that mesh with each other, and how many times they stand round the main axis.
#pragma once

#include <vector>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/gears/gear_train.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// One planet, or those that mesh with each other, of which the first stands on +y.
struct PlanetSet {
  std::vector<int> planets;             ///< of the train, ascending
  const GearMember* counted = nullptr;  ///< its first member that has a count, or null
  const GearMember* shared = nullptr;   ///< likewise of load sharing
  int count = 1;
  double load_sharing = 1.0;  ///< load of the most loaded of them over the mean
};

/// The sets of a train, whose counts must have been checked. Pointers lead into the section.
std::vector<PlanetSet> bind_planet_sets(const GearsDescription& gears,
                                        const GearTrain& train,
                                        Evaluator& evaluator);

/// Of each action, by how many equal planets it is shared: meshes of planets and what bears them.
/// 1 of all others, and of all if the file has no gears or if they are wrong.
std::vector<int> bind_planet_counts(const MechanismDescription& description,
                                    const Topology& topology,
                                    Evaluator& evaluator);

/// Of each body, how many equal planets it stands for; 1 of all others.
std::vector<int> bind_body_counts(const MechanismDescription& description,
                                  const Topology& topology,
                                  Evaluator& evaluator);

/// Of each action, the load of the most loaded of these planets over the mean.
std::vector<double> bind_load_sharing(const MechanismDescription& description,
                                      const Topology& topology,
                                      Evaluator& evaluator);

}  // namespace kinestat
