// Which gears of `gears` turn on the main axis, which on others, and what places each of these.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// An axis beside that about which its carrier turns: of a planet, if the carrier moves, or of a
/// shaft, if it is the ground.
struct GearAxis {
  std::vector<std::string> bodies;  ///< that turn about it, those with gears first
  std::vector<int> members;         ///< ascending
  std::string carrier = {};         ///< the body that holds it
  int about = -1;                   ///< the axis from which it stands off; -1: the main axis
  std::vector<int> on_centre = {};  ///< its meshes with gears on that axis
  int neighbour = -1;               ///< the axis beside which it stands; -1: it stands on +y
  int neighbour_mesh = -1;          ///< the mesh of the two
  PlanetSide side = PlanetSide::left;
  const Value* distance = nullptr;  ///< from `about`, where the file gives it
  std::string distance_giver = {};  ///< the body whose member gave the distance; empty: an axis did
  bool is_in_line = false;          ///< beyond its neighbour, as nothing tells its distance
};

/// The train without its numbers. Pointers lead into the description, which must outlive it.
struct GearTrain {
  std::vector<GearAxis> axes;  ///< each after its neighbour and what it stands off from
  std::vector<int> axis_of;    ///< of each member: index of its axis, -1: the main axis
  std::vector<int> first;      ///< of each mesh: index of its first member
  std::vector<int> second;     ///< of each mesh: index of its second member
  std::vector<int> hand;       ///< of each mesh: 1 if its first member is right-handed where the
                               ///< helix angle of the section is positive, otherwise -1

  /// The index of the axis about which a body turns, or -1.
  int axis_on(std::string_view body) const;

  /// The index of the axis of a bearing between two bodies, or -1: of a planet and its carrier that
  /// of the planet.
  int axis_between(std::string_view tail, std::string_view head) const;
};

/// Shafts and planets: internal/shaft_groups. Of what is no planet, the first axis of `axes` is the
/// main axis, the others stand beside it, as does what has a count, a centre distance or a side.
/// Carriers stand on the main axis unless they mesh on the ground with one that does. Of the rest,
/// what meshes with a gear there stands beside it, what meshes with such gears alone on it. Axes
/// beside one another whose gears mesh form a chain, of which the first of the file stands on +y.
/// Hands alternate along external meshes, beginning with the first gear of the first mesh. The
/// meshes must join members.
GearTrain find_gear_train(const MechanismDescription& description);

}  // namespace kinestat
