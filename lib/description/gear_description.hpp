// The section `gears`: gear trains in teeth, from which the geometry follows.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "description/flank.hpp"
#include "description/value.hpp"

namespace kinestat {

/// Which of two triangles a further axis stands on, seen from its neighbour.
enum class PlanetSide { left, right };

/// A gear wheel; two members may share a body (stepped planets).
struct GearMember {
  Name name;
  Name body;
  Value teeth;
  bool internal = false;                 ///< a ring
  std::optional<Value> count;            ///< how many equal planets there are
  std::optional<Value> load_sharing;     ///< load of the most loaded of them over the mean
  std::optional<Value> centre_distance;  ///< from the axis of its carrier, or the main axis
  PlanetSide side = PlanetSide::left;
};

/// An axis about which several bodies turn, or one on which nothing else puts them. The first of
/// the section is the main axis.
struct GearAxisDescription {
  Name name;
  std::vector<Name> bodies;              ///< one or more
  std::optional<Value> centre_distance;  ///< from the main axis, or the axis of its carrier
  PlanetSide side = PlanetSide::left;
};

/// Two members in mesh; `carrier` is the body that holds their centres apart.
struct MeshDescription {
  Name name;
  Name first;
  Name second;
  std::optional<Name> carrier;
  std::optional<Value> at;              ///< position along the axis
  std::optional<Value> module;          ///< this and the angles: default those of the section
  std::optional<Value> pressure_angle;  ///< in the transverse plane
  std::optional<Value> normal_pressure_angle;  ///< in the plane across the teeth, instead
  std::optional<Value> helix_angle;
};

/// What most teeth are cut with.
inline constexpr std::string_view kUsualPressureAngle = "20 deg";

struct GearsDescription {
  std::optional<Value> module;
  std::optional<Value> pressure_angle;         ///< in the transverse plane
  std::optional<Value> normal_pressure_angle;  ///< in the plane across the teeth, instead
  std::optional<Value> helix_angle;
  Flank flank = Flank::loaded;
  std::vector<GearAxisDescription> axes;
  std::vector<GearMember> members;
  std::vector<MeshDescription> meshes;
  SourceRange where;
};

}  // namespace kinestat
