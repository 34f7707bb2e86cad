// Where the bodies of a coupling stand.
#pragma once

#include <span>

#include "core/index.hpp"
#include "mechanism/couplings/moved_coupling.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// Of its tail and head, and of the body in which its teeth roll.
inline CouplingPoses poses_of(const MotionNetwork& network,
                              const Topology& topology,
                              std::span<const BodyPose> poses,
                              CouplingId coupling) {
  const CouplingTopology& one = topology.coupling(coupling);
  CouplingPoses result = {
      .tail = poses[at(one.tail.value)], .head = poses[at(one.head.value)], .carrier = {}};
  for (const RollingRow& rolling : network.rollings) {
    if (rolling.coupling.value == coupling.value) {
      result.carrier = poses[at(rolling.carrier.value)];
    }
  }
  return result;
}

}  // namespace kinestat
