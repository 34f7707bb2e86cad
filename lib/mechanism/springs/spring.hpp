// A spring, damper or gas spring, bound to numbers.
#pragma once

#include <optional>
#include <string>

#include "core/source.hpp"
#include "core/types.hpp"
#include "description/spring_description.hpp"
#include "mechanism/curves/moving_number.hpp"

namespace kinestat {

/// A gas spring. It pushes with force · (1 - hold · s / stroke)^-exponent, s being its compression
/// from the extended length [m].
struct GasSpring {
  double force = 0.0;   ///< if extended [N]
  double length = 0.0;  ///< if extended [m]
  double stroke = 0.0;  ///< [m]
  double hold = 0.0;  ///< share of its volume that the whole stroke takes: 1 - ratio^(-1/exponent)
  double exponent = 1.0;
};

/// A spring between two points, or about or along a freedom; there it acts as tail on head.
struct Spring {
  std::string name;
  BodyId tail;
  BodyId head;
  Vec3 from = Vec3::Zero();  ///< on the tail, as drawn, from the origin of the geometry [m]
  Vec3 to = Vec3::Zero();    ///< on the head, likewise [m]
  int freedom = -1;          ///< index into Topology::freedoms; -1: between the points
  double stiffness = 0.0;    ///< [N/m or N·m/rad]
  double damping = 0.0;      ///< [N·s/m or N·m·s/rad]
  double free = 0.0;         ///< length or position without spring force [m or rad]
  MovingNumber force;  ///< additional force that pushes [N], or acts on the freedom [N or N·m]
  SpringSense acts = SpringSense::both;
  std::optional<GasSpring> gas;
  SourceRange where;

  bool is_of_freedom() const { return freedom >= 0; }
};

}  // namespace kinestat
