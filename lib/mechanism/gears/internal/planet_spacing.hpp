// Whether several equal planets fit round the main axis: what warnings and conditions of sweeps
// ask.
#pragma once

#include <vector>

#include "mechanism/gears/gear_layout.hpp"
#include "mechanism/gears/internal/planet_assembly.hpp"
#include "mechanism/gears/internal/planet_set.hpp"

namespace kinestat {

/// The meshes of a set, in the order of the file.
std::vector<AssemblyMesh> assembly_meshes(const PlanetSet& set,
                                          const GearTrain& train,
                                          const GearNumbers& numbers);

/// The numbers of teeth that the count must divide, or the planets cannot stand at equal angles
/// (assembly_teeth). None of more planets in a chain than any transmission has, which would outgrow
/// whole numbers.
std::vector<long long> assembly_sums(const PlanetSet& set,
                                     const GearTrain& train,
                                     const GearNumbers& numbers);

/// The first of them that the count does not divide; 0: all are divided.
long long blocking_sum(const PlanetSet& set, const std::vector<long long>& sums);

/// A planet and one of the next set on either side.
struct NeighbourPlanets {
  int first = 0;  ///< members; the same one: a planet and its like
  int second = 0;
  double distance = 0.0;  ///< of their centres [m]
  double needed = 0.0;    ///< at which they would touch [m]

  double clearance() const { return distance - needed; }
};

/// Of one planet, and of planets that mesh with each other. Tips are one module outside the pitch
/// circle.
std::vector<NeighbourPlanets> find_neighbours(const PlanetSet& set,
                                              const GearLayout& layout,
                                              const GearNumbers& numbers);

/// Those of them whose tip circles meet.
std::vector<NeighbourPlanets> find_touching(const PlanetSet& set,
                                            const GearLayout& layout,
                                            const GearNumbers& numbers);

}  // namespace kinestat
