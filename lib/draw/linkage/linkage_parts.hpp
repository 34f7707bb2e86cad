// What a drawing of a mechanism shows of each body: places where couplings are, wheels, cables.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/pose.hpp"

namespace kinestat {

enum class WheelKind {
  gear,   ///< its pitch circle
  ring,   ///< toothed inside
  pulley  ///< a cable runs over it
};

/// A round part of a body. World frame [m].
struct Wheel {
  BodyId body;
  CouplingId at;  ///< the mesh, or a segment of the cable
  WheelKind kind = WheelKind::gear;
  Vec3 centre = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();  ///< unit vector
  double radius = 0.0;
};

/// A straight part of a cable between what it touches.
struct CableLine {
  CouplingId coupling;
  Vec3 from = Vec3::Zero();  ///< on the tail
  Vec3 to = Vec3::Zero();    ///< on the head
};

/// The part of a cable that lies on a pulley, from where it meets it to where it leaves it, turning
/// about +axis where `is_positive`.
struct CableArc {
  BodyId body;  ///< of the pulley
  Vec3 centre = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius = 0.0;
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  bool is_positive = true;
};

/// A spring as it is drawn: between its points, or along the axis of what slides.
struct SpringLine {
  std::size_t spring = 0;    ///< index into Mechanism::springs
  Vec3 from = Vec3::Zero();  ///< on the tail
  Vec3 to = Vec3::Zero();    ///< on the head
  double drawn = 0.0;        ///< its length as drawn [m]
};

/// A place of a body that its drawing reaches.
struct BodyPoint {
  Vec3 at = Vec3::Zero();
  std::optional<CouplingId> coupling;  ///< empty: a spring ends there
};

/// Lists that are said to be of each body are parallel to that of the Topology.
struct LinkageParts {
  std::vector<std::vector<BodyPoint>> points;  ///< of each body; none of virtual links of cables
  std::vector<std::vector<Vec3>> outlines;     ///< of each body, where the file has one
  std::vector<bool> is_virtual;                ///< of each body: a virtual link of a cable
  std::vector<Wheel> wheels;                   ///< one a body, centre and radius
  std::vector<CableLine> spans;
  std::vector<CableArc> arcs;
  std::vector<SpringLine> springs;  ///< all but those about a freedom
};

/// In the drawn position, or with these poses of all bodies; `mechanism` is as drawn.
LinkageParts find_linkage_parts(const MechanismDescription& description,
                                const Mechanism& mechanism,
                                std::span<const BodyPose> poses = {});

/// The wheels of one coupling of teeth; the pinion alone of a rack.
struct MeshWheels {
  CouplingId coupling;
  std::optional<Wheel> tail;
  std::optional<Wheel> head;
};

/// In the order of the couplings. A wheel turns about the hinge that its body has in common with
/// the carrier of the mesh; without one about its nearest. Empty where a body has no hinge.
std::vector<MeshWheels> find_mesh_wheels(const MechanismDescription& description,
                                         const Mechanism& mechanism);

}  // namespace kinestat
