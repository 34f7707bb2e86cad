// Which freedoms move together: a basis of the motions that people can read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/bounded_screw.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// One independent motion at the drawn position. The first freedom that moves has the rate 1.
struct FreeMotion {
  VecX rates;                   ///< one a freedom [rad/s or m/s]
  std::vector<Twist> bodies;    ///< of each body, the ground first [SI]
  std::vector<BodyId> passive;  ///< bodies that move alone, felt by nobody; empty: no such motion
  int first = 0;                ///< the freedom whose rate is 1

  bool is_passive() const { return !passive.empty(); }

  /// About which a body turns or along which it shifts, without what rounding leaves; `length` [m]
  /// is the size of the mechanism. Empty if it rests.
  std::optional<ScrewAxis> axis_of(std::size_t body, double length) const {
    return find_axis(written(bodies[body]), length);
  }
};

struct MotionSpace {
  int net_freedom = 0;              ///< F_N
  std::vector<FreeMotion> motions;  ///< passive ones last; empty where they are too many to read
};

/// The motions that the couplings allow, F_N of them: the reduced echelon form in which actuators
/// come first, then the freedoms in file order. Passive freedoms are told apart, and the other
/// motions leave them at rest.
MotionSpace find_motion_space(const Mechanism& mechanism, const CoordinateBasis& basis);

}  // namespace kinestat
