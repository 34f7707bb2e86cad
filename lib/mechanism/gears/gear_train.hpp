// The axes of the gears of `gears`: which gears turn on which axis, and how the axes are placed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// An axis beside the one about which its carrier turns: that of a planet if the carrier moves, or
/// of a shaft if the carrier is the ground.
struct GearAxis {
  std::vector<std::string> bodies;  ///< that turn about it, those with gears first
  std::vector<int> members;         ///< the gear members on it, ascending
  std::string carrier = {};         ///< the body in which it is fixed
  int about = -1;                   ///< the axis around which it is placed; -1: the main axis
  std::vector<int> on_centre = {};  ///< its meshes with gears on the axis `about`
  int neighbour = -1;               ///< the axis beside which it is placed; -1: it is on +y
  int neighbour_mesh = -1;          ///< its mesh with the neighbour
  PlanetSide side = PlanetSide::left;
  const Value* distance = nullptr;  ///< from `about`, if the file gives it
  std::string distance_giver = {};  ///< the body whose member gave the distance; empty: an axis did
  bool is_in_line = false;          ///< placed beyond its neighbour, as its distance is not known
};

/// The train without its numbers. Pointers lead into the description, which must outlive it.
struct GearTrain {
  std::vector<GearAxis> axes;  ///< each after its neighbour and the axis `about`
  std::vector<int> axis_of;    ///< of each member: index of its axis, -1: the main axis
  std::vector<int> first;      ///< of each mesh: index of its first member
  std::vector<int> second;     ///< of each mesh: index of its second member
  std::vector<int> hand;       ///< of each mesh: 1 if its first member is right-handed where the
                               ///< helix angle of the section is positive, otherwise -1

  /// The index of the axis about which a body turns, or -1.
  int axis_on(std::string_view body) const;

  /// The index of the axis of a bearing between two bodies, or -1. For a planet and its carrier it
  /// is the axis of the planet.
  int axis_between(std::string_view tail, std::string_view head) const;
};

/// Finds the axes of a train; internal/shaft_groups tells shafts from planets. For shafts:
/// - the first of the file's `axes` is the main axis; the others are beside it, and so are shafts
///   with a count, a centre distance or a side;
/// - carriers are on the main axis, unless they mesh on the ground with a body that is on it;
/// - of the rest, a shaft is beside the main axis if it meshes with a gear on it, and on the main
///   axis if it meshes only with gears beside it.
/// Axes beside one another whose gears mesh form a chain, of which the first in the file is on +y.
/// Hands alternate along external meshes, beginning with the first gear of the first mesh. The
/// meshes must join members.
GearTrain find_gear_train(const MechanismDescription& description);

}  // namespace kinestat
