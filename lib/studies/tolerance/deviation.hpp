// How parts may differ from the drawing where couplings join them.
#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/twist.hpp"

namespace kinestat {

/// One way in which the head of a coupling may stand otherwise to its tail than drawn, all freedoms
/// being where they are drawn: what an action of the coupling holds there. A force holds a place
/// along its line, a couple an angle about its axis through the point of the coupling.
struct Deviation {
  int action = 0;                 ///< index into Topology::actions
  bool is_angle = false;          ///< [rad], otherwise [m]
  bool is_counted = true;         ///< false: of a rope that slips on pulleys, whose one length
                                  ///< counts at its first segment
  Vec3 direction = Vec3::Zero();  ///< unit vector, world frame
  Twist unit;  ///< head relative to tail for 1 rad or 1 m, about the geometry's origin
};

/// Of all passive constraints; what actuators bear is a place of the drive and none of a part.
std::vector<Deviation> part_deviations(const Mechanism& mechanism);

}  // namespace kinestat
