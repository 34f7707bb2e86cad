// A spring, damper or gas spring in numbers.
#pragma once

#include <optional>
#include <string>

#include "core/source.hpp"
#include "core/types.hpp"
#include "description/spring_description.hpp"
#include "mechanism/curves/moving_number.hpp"

namespace kinestat {

/// Pushes with force · (1 - hold · s / stroke)^-exponent, s being how far it is pushed in.
struct GasSpring {
  double force = 0.0;   ///< extended [N]
  double length = 0.0;  ///< there [m]
  double stroke = 0.0;  ///< [m]
  double hold = 0.0;    ///< of its volume, what the whole stroke takes: 1 - ratio^(-1/exponent)
  double exponent = 1.0;
};

/// Between two points, or about or along a freedom, of which its action is that of tail on head.
struct Spring {
  std::string name;
  BodyId tail;
  BodyId head;
  Vec3 from = Vec3::Zero();  ///< on the tail as drawn, from the origin of the geometry [m]
  Vec3 to = Vec3::Zero();    ///< on the head
  int freedom = -1;          ///< index into Topology::freedoms; -1: between the points
  double stiffness = 0.0;    ///< [N/m or N·m/rad]
  double damping = 0.0;      ///< [N·s/m or N·m·s/rad]
  double free = 0.0;         ///< length or position without force [m or rad]
  MovingNumber force;        ///< beside these: pushes [N], or acts on the freedom [N or N·m]
  SpringSense acts = SpringSense::both;
  std::optional<GasSpring> gas;
  SourceRange where;

  bool is_of_freedom() const { return freedom >= 0; }
};

}  // namespace kinestat
