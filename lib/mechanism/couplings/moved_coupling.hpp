// The unit screws of a coupling in a moved position.
#pragma once

#include "mechanism/couplings/drawn_coupling_binder.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// Where the two bodies of a coupling stand, and the body in which teeth roll.
struct CouplingPoses {
  BodyPose tail;
  BodyPose head;
  BodyPose carrier;
};

/// The screws of the drawn position as they follow the bodies, in the same order. What a coupling
/// frees and bears follows the body in which it is fixed, as FiniteLaw says; forces at a point (Rx,
/// Ry, Rz), all couples of a slider and the freedoms of a ball keep their world directions; what
/// touches and what pulls follows the moved contact and the moved cable.
struct MovedCoupling {
  std::vector<Twist> motions;   ///< of the freedoms
  std::vector<Wrench> actions;  ///< of the passive constraints, then of the actuators
  Vec3 point = Vec3::Zero();    ///< of the coupling [m]
};

MovedCoupling moved_coupling(const Mechanism& mechanism,
                             CouplingId coupling,
                             const DrawnCoupling& drawn,
                             const CouplingPoses& poses);

/// The stations of a segment of a cable where their bodies have taken them.
CableStationGeometry moved_station(CableStationGeometry station, const BodyPose& pose);

}  // namespace kinestat
