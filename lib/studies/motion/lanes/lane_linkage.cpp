#include "studies/motion/lanes/lane_linkage.hpp"

#include <algorithm>

#include "core/index.hpp"

namespace kinestat {

namespace {

bool is_plain_pair(const CouplingTopology& coupling) {
  return (coupling.type == CouplingType::revolute || coupling.type == CouplingType::prismatic) &&
         coupling.freedom_count == 1;
}

bool is_plain(const Mechanism& mechanism, const MotionNetwork& network) {
  const auto is_driven = [&](const MotionJoint& one) {
    return one.freedom == network.driven_freedoms.front();
  };
  return network.space == Space::planar && network.is_movable() &&
         network.driven_freedoms.size() == 1 && network.rollings.empty() && network.balls.empty() &&
         network.arcs.empty() && network.passive_motions.empty() && network.drawn_misses.empty() &&
         std::ranges::all_of(mechanism.topology.couplings, is_plain_pair) &&
         std::ranges::all_of(network.joints,
                             [](const MotionJoint& one) {
                               return one.coordinate >= 0 && one.freedom >= 0 &&
                                      one.motion.kind != ElementaryKind::ball;
                             }) &&
         std::ranges::count_if(network.joints, is_driven) == 1;
}

// The joints that only one of the two frames follows. Frames are numbered from the ground outwards.
std::vector<LaneClosing::Term> terms_between(int tail,
                                             int head,
                                             const std::vector<LaneJoint>& joints) {
  std::vector<LaneClosing::Term> terms;
  while (tail != head) {
    int& outer = tail > head ? tail : head;
    terms.push_back({.joint = outer - 1, .sign = tail > head ? -1.0 : 1.0});
    outer = joints[at(outer - 1)].parent;
  }
  return terms;
}

bool turns(const Topology& topology, int freedom) {
  return topology.freedoms[at(freedom)].is_rotation;
}

}  // namespace

int LaneLinkage::joint_of(int freedom) const {
  const auto found = std::ranges::find(joints, freedom, &LaneJoint::freedom);
  return found == joints.end() ? -1 : static_cast<int>(found - joints.begin());
}

std::optional<LaneLinkage> make_lane_linkage(const Mechanism& mechanism,
                                             const MotionNetwork& network) {
  if (!is_plain(mechanism, network)) {
    return std::nullopt;
  }
  const Topology& topology = mechanism.topology;
  LaneLinkage result;
  result.length = network.length;
  int unknowns = 0;
  for (const MotionJoint& joint : network.joints) {
    const bool is_driven = joint.freedom == network.driven_freedoms.front();
    if (is_driven) {
      result.driven_joint = static_cast<int>(result.joints.size());
    }
    result.joints.push_back({.parent = joint.parent,
                             .freedom = joint.freedom,
                             .turns = turns(topology, joint.freedom),
                             .sense = joint.sense,
                             .unknown = is_driven ? -1 : unknowns++});
  }
  for (std::size_t c = 0; c < topology.couplings.size(); ++c) {
    const CouplingTopology& coupling = topology.couplings[c];
    if (result.joint_of(coupling.first_freedom) >= 0) {
      continue;
    }
    const int tail = network.frame_of_body[at(coupling.tail.value)];
    const int head = network.frame_of_body[at(coupling.head.value)];
    result.closings.push_back({.freedom = coupling.first_freedom,
                               .turns = turns(topology, coupling.first_freedom),
                               .tail_frame = tail,
                               .head_frame = head,
                               .point = mechanism.geometry.points[c],
                               .terms = terms_between(tail, head, result.joints)});
  }
  return unknowns > 0 && unknowns == result.unknown_count() ? std::optional(std::move(result))
                                                            : std::nullopt;
}

std::optional<LaneTransmission> find_lane_transmission(const Mechanism& mechanism,
                                                       const MotionNetwork& network,
                                                       int input,
                                                       int output) {
  const Topology& topology = mechanism.topology;
  const int driving = topology.actuators[at(input)].freedom;
  const int driven = topology.actuators[at(output)].freedom;
  const auto coupling_of = [&](int freedom) { return topology.freedoms[at(freedom)].coupling; };
  const CouplingTopology& out = topology.coupling(coupling_of(driven));
  if (driving != network.driven_freedoms.front() || driving == driven ||
      mechanism.static_order == OrderChoice::spatial || out.tail.value != 0) {
    return std::nullopt;
  }
  const BodyId body = out.head;
  // Of all couplings of a body the one beside another, if there is no third.
  const auto other_of = [&](BodyId of, CouplingId beside) -> std::optional<CouplingId> {
    std::optional<CouplingId> found;
    for (int c = 0; c < topology.coupling_count(); ++c) {
      const CouplingTopology& one = topology.coupling({c});
      if (c == beside.value || (one.tail != of && one.head != of)) {
        continue;
      }
      if (found) {
        return std::nullopt;
      }
      found = CouplingId{c};
    }
    return found;
  };
  const std::optional<CouplingId> near = other_of(body, coupling_of(driven));
  if (!near || topology.coupling(*near).type != CouplingType::revolute) {
    return std::nullopt;
  }
  const CouplingTopology& joined = topology.coupling(*near);
  const BodyId link = joined.tail == body ? joined.head : joined.tail;
  const std::optional<CouplingId> far = link.value == 0 ? std::nullopt : other_of(link, *near);
  if (!far || topology.coupling(*far).type != CouplingType::revolute ||
      *far == coupling_of(driving) || *near == coupling_of(driving)) {
    return std::nullopt;
  }
  return LaneTransmission{.near = joined.first_freedom,
                          .near_frame = network.frame_of_body[at(body.value)],
                          .far = topology.coupling(*far).first_freedom,
                          .far_frame = network.frame_of_body[at(link.value)],
                          .output = driven,
                          .turns = turns(topology, driven),
                          .holding_frame = network.frame_of_body[at(out.tail.value)]};
}

}  // namespace kinestat
