// The unit screws of a coupling in a moved position.
#pragma once

#include "mechanism/couplings/drawn_coupling_binder.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// The poses of the two bodies of a coupling and, for teeth, of their carrier.
struct CouplingPoses {
  BodyPose tail;
  BodyPose head;
  BodyPose carrier;
};

/// The screws of a coupling in a moved position, in the same order as drawn. They follow the body
/// in which the coupling is fixed (FiniteLaw). Forces at a point (Rx, Ry, Rz), all couples of a
/// slider and the freedoms of a ball joint keep their directions in the world. Screws of contacts
/// and cables follow the moved contact and the moved cable.
struct MovedCoupling {
  std::vector<Twist> motions;   ///< of the freedoms
  std::vector<Wrench> actions;  ///< of the passive constraints, then of the actuators
  Vec3 point = Vec3::Zero();    ///< of the coupling [m]
};

MovedCoupling moved_coupling(const Mechanism& mechanism,
                             CouplingId coupling,
                             const DrawnCoupling& drawn,
                             const CouplingPoses& poses);

/// A station of a cable segment, moved with its body.
CableStationGeometry moved_station(CableStationGeometry station, const BodyPose& pose);

}  // namespace kinestat
