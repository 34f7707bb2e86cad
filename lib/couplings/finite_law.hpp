// The law of a coupling that holds in every position, not only in the drawn one.
#pragma once

#include <vector>

#include "couplings/drawn_coupling.hpp"
#include "description/coupling_description.hpp"

namespace kinestat {

enum class ElementaryKind { turn, slide, ball };

/// A part of the motion of the head relative to the tail: a turn about a line, with a slide of
/// `pitch` a radian along it, a slide, or any turn about a point.
struct ElementaryMotion {
  ElementaryKind kind = ElementaryKind::turn;
  Vec3 direction = Vec3::UnitZ();  ///< unit vector in the drawn position
  Vec3 point = Vec3::Zero();       ///< of the line, or the centre of the ball [m]
  double pitch = 0.0;              ///< [m/rad]
  int freedom = 0;                 ///< of the coupling; a ball has three from here on
};

/// One equation or, of points that meet, one for each direction of the space. What is named tail
/// and head is fixed in the two bodies, in the drawn position.
enum class ClosureKind {
  meet,    ///< the two points coincide
  along,   ///< the head's point keeps the height `value` over the plane through the tail's point
           ///< across `tail`
  across,  ///< tail · head is `value`
  screw,   ///< from the tail's point the head's has moved along `tail` by value (pitch) · turn
  reach,   ///< the two points keep the distance `value`
  cable    ///< the cable between two pulleys is as long as what they give and take
};

struct ClosureCondition {
  ClosureKind kind = ClosureKind::meet;
  bool is_reversed = false;  ///< tail and head change their parts
  Vec3 tail_point = Vec3::Zero();
  Vec3 head_point = Vec3::Zero();
  Vec3 tail = Vec3::Zero();
  Vec3 head = Vec3::Zero();
  double value = 0.0;
  double tail_radius = 0.0;  ///< of a cable: signed radii about +z; 0: a point
  double head_radius = 0.0;
};

/// How the position of a freedom follows from the poses of tail and head. A turn: the angle about
/// `axis` from `from` to `to`, the first two fixed in the one body, `to` in the other. A slide:
/// how far the head's point is from the tail's along `axis`.
struct FreedomMeasure {
  int freedom = 0;  ///< of the coupling
  bool is_turn = true;
  bool is_in_head = false;  ///< `axis` and `from` are fixed in the head
  double sense = 1.0;
  Vec3 axis = Vec3::UnitZ();
  Vec3 from = Vec3::UnitX();
  Vec3 to = Vec3::UnitX();
  Vec3 tail_point = Vec3::Zero();
  Vec3 head_point = Vec3::Zero();
};

enum class LawKind {
  chain,    ///< elementary motions in series; or the conditions that say the same
  contact,  ///< conditions alone
  rolling,  ///< teeth: see make_motion_network
  unknown   ///< the file does not say enough
};

struct FiniteLaw {
  LawKind kind = LawKind::chain;
  std::vector<ElementaryMotion> chain;       ///< from the tail to the head
  std::vector<ClosureCondition> conditions;  ///< as many equations as the coupling has constraints
  std::vector<FreedomMeasure> measures;      ///< of the freedoms that have positions
};

/// Which body a slot, tube, axis or plane is fixed in: the axis of a prismatic, helical or
/// cylindrical coupling, a hinge and a plane are fixed in both; the pin and the sphere in the tail,
/// their slot and tube in the head; the first axis of a universal coupling in the tail, the second
/// in the head.
FiniteLaw finite_law(CouplingType type, Space space, const DrawnCoupling& drawn);

}  // namespace kinestat
