// Which bodies of a gear train turn about one axis, and which of them are planets.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// A body of a train, or a gear that is fixed to the ground: only its own axis says where it is.
struct Shaft {
  std::string body;
  bool is_on_ground = false;
  std::vector<int> members = {};  ///< ascending
  std::vector<int> meshes = {};   ///< of its members, ascending
  int carrier = -1;               ///< the shaft that bears it as its planet, -1: it is none
  int group = -1;                 ///< of all that turn about one axis
};

struct ShaftGroups {
  std::vector<Shaft> shafts;  ///< those with members first, in the order of these
  std::vector<int> shaft_of;  ///< of each member
  std::vector<int> first;     ///< of each mesh: index of its first member
  std::vector<int> second;    ///< of each mesh: index of its second member
  int count = 0;              ///< of groups
  std::map<std::string, int, std::less<>> of_body = {};  ///< the shaft of each body that moves

  /// The shaft with which one meshes there.
  int mate(int mesh, int shaft) const;

  /// The shaft of a body that moves, or -1.
  int shaft_named(std::string_view body) const;
};

/// Of the meshes with a carrier that moves, a ring and what is itself a carrier are no planets;
/// what meshes with a ring is one; what other bodies than the carrier bear is none, unless it has a
/// count, a centre distance or a side; what the carrier alone bears is one. Of the rest, what
/// meshes with a planet is none, and the other way about.
///
/// About one axis turn: a carrier and what meshes with its planets in it; two bodies that a clutch
/// joins, unless one is a planet and the other not of the same carrier; the bodies of an axis of
/// the section. The meshes must join members.
ShaftGroups find_shaft_groups(const MechanismDescription& description);

}  // namespace kinestat
