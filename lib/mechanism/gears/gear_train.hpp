// Which gears of `gears` turn on the main axis, which are planets, and what places each planet.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// A body with planets. Several members on it are a stepped planet.
struct PlanetAxis {
  std::string body;
  std::vector<int> members;  ///< ascending
  std::vector<int> on_main;  ///< its meshes with gears on the main axis
  int neighbour = -1;        ///< the planet beside which it stands; -1: it stands on +y
  int neighbour_mesh = -1;   ///< the mesh of the two
  PlanetSide side = PlanetSide::left;
  const Value* distance = nullptr;       ///< from the main axis, where the file gives it
  std::vector<std::string> shafts = {};  ///< bodies without gears that clutches join to it
};

/// The train without its numbers. Pointers lead into the description, which must outlive it.
struct GearTrain {
  std::vector<PlanetAxis> planets;  ///< each after its neighbour
  std::vector<int> planet_of;       ///< of each member: index of its planet, -1: on the main axis
  std::vector<int> first;           ///< of each mesh: index of its first member
  std::vector<int> second;          ///< of each mesh: index of its second member
  std::vector<int> hand;  ///< of each mesh: 1 if its first member is right-handed where the
                          ///< helix angle of the section is positive, otherwise -1

  /// The index of the planet on whose axis a body turns, or -1.
  int planet_on(std::string_view body) const;
};

/// Rings stand on the main axis; what meshes with a ring, has a count, a centre distance or a side,
/// or turns on its carrier alone, is a planet. The first body of a train where none stands on the
/// main axis does. Of the rest, what meshes with a gear there is a planet, and what meshes with
/// planets alone stands on the main axis. Planets that mesh with each other form a chain, of which
/// the first of the file stands on +y. Hands alternate along external meshes, beginning with the
/// first gear of the first mesh. The meshes must join members.
GearTrain find_gear_train(const MechanismDescription& description);

}  // namespace kinestat
