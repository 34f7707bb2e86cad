// What a kind of coupling is: its word, the keys that it takes, and what follows from them.
#pragma once

#include <span>
#include <string_view>

#include "description/coupling_description.hpp"

namespace kinestat {

/// What some kinds take in the file, in the order in which it is read and written. Every kind has
/// type, bodies, passive, friction and stiffness beside.
enum class CouplingKey {
  at,
  turning_axis,  ///< of three components, also in the plane
  sliding_axis,  ///< of as many as the space has
  axes,
  normal,
  line,
  radii,
  slot,
  pitch,
  lead,
  tangent,
  pressure_angle,
  helix_angle,
  internal,
  contact,
  line_of_action,
  screw,
  flank,
  from,
  to,
  freedoms,
  constraints,
  one_way,
  stator,
  characteristic
};

/// A key of a kind; the meaning is a sentence, empty where it is that of the key in every kind.
struct KindKey {
  CouplingKey key = CouplingKey::at;
  std::string_view meaning = {};
};

/// Where friction acts, and with it what may be said of it.
enum class FrictionKind {
  journal,  ///< mu with radius, thrust_radius, length, tau, c
  thread,   ///< mu with radius, tau, c
  guide,    ///< mu, length, radius, c
  sliding,  ///< mu; of contacts and teeth
  drag,     ///< tau, c; of what engages, while it is open
  no_law,   ///< all, as it is not analysed yet
  fluid     ///< nothing: of a torque converter, whose characteristic says all
};

/// Whether such friction is a couple about the axis of the coupling; otherwise it is a force.
constexpr bool is_couple(FrictionKind kind) {
  return kind != FrictionKind::guide && kind != FrictionKind::sliding;
}

/// Between which bodies teeth mesh.
enum class Teeth {
  none,
  of_wheels,  ///< each of which may be a planet
  of_any      ///< of any two bodies
};

/// How it is drawn in the plane.
enum class PlanarSymbol { pin, block, slot, contact, rack, bars, square };

/// How it is drawn in space.
enum class SpaceSymbol { square, hinge, sleeve, box, cross, ball, plate, touching_plate };

struct KindMechanics;

/// A row of the list of kinds. All texts are literals.
struct CouplingKind {
  CouplingType type = CouplingType::revolute;
  std::string_view word = {};                     ///< behind 'type:'
  std::string_view meaning = {};                  ///< what it frees and needs
  std::string_view example = {};                  ///< as in a file
  std::span<const std::string_view> others = {};  ///< what it is called elsewhere, in lower case
  std::span<const KindKey> keys = {};
  const KindMechanics* mechanics = nullptr;
  FrictionKind friction = FrictionKind::no_law;
  bool is_in_plane = true;           ///< may stand in a planar mechanism
  bool is_in_space = true;           ///< may stand in a spatial one
  bool needs_place = true;           ///< 'at', without which it is only counted
  bool frees_more_in_space = false;  ///< than it does in the plane
  Teeth teeth = Teeth::none;
  bool is_hinge = false;     ///< its bodies turn about one axis
  bool is_bearing = false;   ///< holds one body in another, as guides do
  bool only_pushes = false;  ///< surfaces that part rather than pull
  PlanarSymbol planar_symbol = PlanarSymbol::pin;
  SpaceSymbol space_symbol = SpaceSymbol::square;
  bool engages = false;  ///< and opens: an actuator of its own name
};

}  // namespace kinestat
