// Clutches and brakes that hold one sense of torque.
#pragma once

#include <optional>
#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// A clutch or brake with `one_way`.
struct Freewheel {
  CouplingId coupling;
  int action = 0;   ///< its torque, of the tail on the head: index into Topology::actions
  int freedom = 0;  ///< its slip, of the head relative to the tail: index into Topology::freedoms
  int holds = 1;  ///< sign of the torque that it holds, and of the slip with which it turns freely
};

/// What a freewheel cannot do, though an answer asks it to.
enum class FreewheelFault {
  overruns,  ///< it would have to hold a torque of the other sign
  locks      ///< it would have to slip in the sense in which it holds
};

/// `torque` [N·m] and `slip` [rad/s] are those of the freewheel; at most one of them is not zero,
/// but for friction that slips.
std::optional<FreewheelFault> fault_of(const Freewheel& freewheel, double torque, double slip);

/// Those that the file writes, in the order of the couplings.
std::vector<Freewheel> bind_freewheels(const MechanismDescription& description,
                                       const Topology& topology);

}  // namespace kinestat
