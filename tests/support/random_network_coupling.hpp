// A coupling of a random network: a type, two bodies and what the file says of its geometry.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/types.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

struct NetworkPoint {
  Vec3 at = Vec3::Zero();
};

struct NetworkDirection {
  Vec3 vector = Vec3::UnitZ();  ///< of any length
  std::string keyword = {};     ///< "x", "-z", …; empty: the vector is written
};

struct NetworkLength {
  double metres = 0.0;
};

struct NetworkAngle {
  double radians = 0.0;
};

struct NetworkScrew {
  ScrewWord kind = ScrewWord::rotation;
  NetworkDirection direction;
  Vec3 at = Vec3::Zero();  ///< of a rotation or force
  double pitch = 0.0;      ///< of a rotation or force; not written if zero

  bool has_line() const { return kind == ScrewWord::rotation || kind == ScrewWord::force; }
};

using NetworkValue = std::variant<bool,
                                  NetworkPoint,
                                  NetworkDirection,
                                  NetworkLength,
                                  NetworkAngle,
                                  NetworkScrew,
                                  std::vector<NetworkDirection>,
                                  std::vector<NetworkScrew>>;

struct NetworkKey {
  std::string word;  ///< "at", "normal", "freedoms", …
  NetworkValue value;
};

struct NetworkCoupling {
  std::string name;
  CouplingType type = CouplingType::revolute;
  int tail = 0;
  int head = 0;
  std::vector<NetworkKey> keys;
  std::optional<std::vector<int>> passive;  ///< numbers of the constraints that it keeps
  bool is_named = false;                    ///< the text names some of its freedoms or constraints
  std::vector<std::string> freedoms;        ///< their names, if it is named
  std::vector<std::string> constraints;     ///< their names, if it is named

  /// The value of a key; empty pointer if it is not written.
  const NetworkValue* find(std::string_view word) const;
  NetworkValue* find(std::string_view word);
};

/// Whether the file says where it is. Otherwise its forces act at a point that the program chooses.
bool has_place(const NetworkCoupling& coupling);

/// Whether its freedoms and passive constraints are as many as the order of the space. Not so:
/// teeth that roll, clutches, brakes, screws of which both sides are listed in part, and
/// `passive:`.
bool is_complementary(const NetworkCoupling& coupling, Space space);

/// The freedoms whose screws move with the coupling, so that an actuator on them is the same one in
/// every position of the world. The others are along the axes of the world.
std::vector<int> own_freedoms(const NetworkCoupling& coupling, Space space);

}  // namespace kinestat
