// The flanks of teeth that the file writes as couplings, in the place of `gears`.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Teeth of which is known in which plane both bodies roll or slide on each other at their point:
/// that of the pitch velocities. The other flank is the one mirrored in it.
struct ToothRule {
  CouplingId coupling;
  int action = 0;          ///< the force of the teeth, into Topology::actions
  int tail = -1;           ///< the freedom about whose axis, or along which, the tail moves; -1:
                           ///< not known, and then that of the head is
  int head = -1;           ///< likewise of the head
  bool by_head = false;    ///< which of the two gives the pitch velocity
  bool slides = false;     ///< as a worm does: the teeth slide at the point, else they roll
  bool internal = false;   ///< as the file says; where one body is not known
  bool has_other = false;  ///< the tangent of the file gives the other flank
};

/// Teeth that turn with their load.
struct TurningTeeth {
  CouplingId coupling;
  int action = 0;
  bool internal = false;
  bool has_other = false;
};

/// Finds the rules of teeth as drawn; none of those for which the hinges and guides of the two
/// bodies give no plane, or several. The axes must agree with the relative motion of the teeth.
std::vector<ToothRule> find_tooth_rules(const Topology& topology,
                                        const Geometry& geometry,
                                        const std::vector<TurningTeeth>& teeth);

/// The normal of the pitch plane, of any length: the cross product of the pitch velocity and the
/// velocity of sliding, or the axis of rolling.
template <class Scalar>
Vec3Of<Scalar> pitch_normal(const ToothRule& rule,
                            const Topology& topology,
                            const GeometryOf<Scalar>& geometry);

/// Whether teeth that push the head along `line` would rather pull: external teeth push each other
/// apart, a ring pushes its wheel inwards. The wheel that is curved more has external teeth. False
/// where that is not known, or along the tangent. `point` is that of the coupling, of which a
/// geometry that is rebound keeps the drawn one.
bool is_pulling(const ToothRule& rule,
                const Topology& topology,
                const std::vector<Twist>& motions,
                const Vec3& point,
                const Vec3& line);

}  // namespace kinestat
