// A coupling as the user wrote it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "description/cable_description.hpp"
#include "description/converter_description.hpp"
#include "description/flank.hpp"
#include "description/friction_description.hpp"
#include "description/screw_description.hpp"
#include "description/value.hpp"

namespace kinestat {

enum class Space { planar, spatial };

/// What each is, lib/couplings says.
enum class CouplingType {
  revolute,
  prismatic,
  helical,
  cylindrical,
  universal,
  spherical,
  planar,
  point_contact,
  cam,
  line_contact,
  sphere_in_tube,
  pin_in_slot,
  rigid,
  gear,
  bevel_gear,
  worm,
  rack,
  clutch,
  brake,
  torque_converter,
  cable,
  screws
};

/// Whether shafts that it joins turn about one axis and are else held apart by their bearings.
constexpr bool joins_one_axis(CouplingType type) {
  return type == CouplingType::clutch || type == CouplingType::torque_converter;
}

/// Where a coupling is. Usually one point; a point for each body where the drawing shows the two
/// apart, or a single number along the axis where `gears` places the bodies. If it has none of
/// these it stands on that axis, in the plane.
struct CouplingPoint {
  std::optional<PointDescription> point;
  std::vector<std::pair<Name, PointDescription>> of_bodies;  ///< as drawn on each body
  std::optional<Value> along_axis;
  SourceRange where;

  /// Whether `gears` places it, as far as the file does not.
  bool is_on_gear_axis() const { return !point && of_bodies.empty(); }
};

/// Stiffness of one constraint: [N/m] of a force, [N·m/rad] of a couple.
struct StiffnessDescription {
  Name action;
  Value value;
};

/// The direction in which a freewheel bears a torque.
enum class OneWay { positive, negative };

/// Edge tail -> head. What is large and rare is shared among copies, because files may have tens of
/// thousands of couplings. Which geometry a type needs is checked when it is bound.
struct CouplingDescription {
  Name name;
  CouplingType type = CouplingType::revolute;
  Name tail;
  Name head;
  std::optional<CouplingPoint> at;
  std::optional<AxisDescription> axis;
  std::vector<AxisDescription> axes;              ///< of a universal: fixed in tail, in head
  std::optional<AxisDescription> normal;          ///< of a planar coupling or a contact
  std::optional<AxisDescription> line;            ///< of a line contact
  std::vector<std::optional<Value>> radii;        ///< of a contact: of the tail, of the head where
                                                  ///< they touch; empty: flat
  std::optional<AxisDescription> slot;            ///< of a pin in a slot
  std::optional<Value> pitch;                     ///< of a helical: length per radian
  std::optional<Value> lead;                      ///< of a helical: length per turn
  std::optional<AxisDescription> tangent;         ///< of a gear
  std::optional<AxisDescription> line_of_action;  ///< of a gear, instead of tangent and angle
  std::optional<Value> pressure_angle;            ///< of a gear
  std::optional<Value> normal_pressure_angle;     ///< of a mesh of `gears`, instead
  std::optional<Value> helix_angle;               ///< of a gear
  bool internal = false;                          ///< of a gear: one of the two is a ring
  bool contact = false;         ///< of a gear: the contact of the teeth instead of a rolling pair
  Flank flank = Flank::loaded;  ///< of teeth; of a mesh `gears` says it
  std::shared_ptr<const ScrewDescription> screw;  ///< relative motion of a bevel gear, worm, rack
  std::optional<PointDescription> from;           ///< of a cable: its end on the tail
  std::optional<PointDescription> to;             ///< of a cable: its end on the head
  std::vector<ScrewDescription> freedoms;         ///< of type screws
  std::vector<ScrewDescription> constraints;      ///< of type screws
  std::optional<OneWay> one_way;                  ///< of a clutch or brake: a freewheel
  std::optional<Name> stator;  ///< of a torque converter: the body on which it reacts
  std::shared_ptr<const CharacteristicDescription> characteristic;  ///< of a torque converter
  std::string stator_of;  ///< of the second coupling of a torque converter: the name of the first
  std::optional<std::vector<Name>> passive;             ///< the constraints that it keeps
  std::shared_ptr<const FrictionDescription> friction;  ///< may be null
  std::vector<StiffnessDescription> stiffness;
  std::shared_ptr<const CablePart> part;  ///< of a coupling that `cables` makes, otherwise null
  int mesh = -1;  ///< of a coupling that `gears` makes: index of its mesh, otherwise -1

  /// Whether it is a segment that `cables` makes, whose ends follow from its stations.
  bool is_segment() const { return part != nullptr && part->segment > 0; }

  /// Whether it is a mesh of `gears`, whose pitch point and tangent follow from the train.
  bool is_mesh() const { return mesh >= 0; }
};

}  // namespace kinestat
