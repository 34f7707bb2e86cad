// Planar linkages of turning and sliding pairs, so prepared that many of them move at once.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// A joint of the tree; joint j makes frame j + 1.
struct LaneJoint {
  int parent = 0;   ///< frame before
  int freedom = 0;  ///< index into Topology::freedoms
  bool turns = true;
  double sense = 1.0;
  int unknown = -1;  ///< among the coordinates that follow; -1: it is driven
};

/// A coupling outside the tree, which gives two equations.
struct LaneClosing {
  int freedom = 0;
  bool turns = true;
  int tail_frame = 0;
  int head_frame = 0;
  Vec3 point = Vec3::Zero();  ///< of a slide: any in the drawn position [m]

  // A joint that only one of the two frames follows; +1: the head.
  struct Term {
    int joint = 0;
    double sign = 1.0;
  };

  std::vector<Term> terms;
};

/// What drives an output: a link between two turning pairs.
struct LaneTransmission {
  int near = 0;        ///< freedom of the pair with the driven body,
  int near_frame = 0;  ///< which moves with this frame
  int far = 0;         ///< freedom of the other pair
  int far_frame = 0;   ///< of the link
  int output = 0;      ///< freedom of the output
  bool turns = true;   ///< it does
  int holding_frame = 0;
};

struct LaneLinkage {
  double length = 1.0;  ///< by which coordinates that slide are divided [m]
  std::vector<LaneJoint> joints;
  std::vector<LaneClosing> closings;
  int driven_joint = 0;

  int unknown_count() const { return 2 * static_cast<int>(closings.size()); }

  /// The joint of the tree, or -1.
  int joint_of(int freedom) const;
};

/// Empty for any other mechanism, and for one whose drawing does not close or whose drive leaves
/// something open. `network` is that of one drive.
std::optional<LaneLinkage> make_lane_linkage(const Mechanism& mechanism,
                                             const MotionNetwork& network);

/// Empty where the transmission angle follows from more than the place of one link; `input` and
/// `output` are actuators.
std::optional<LaneTransmission> find_lane_transmission(const Mechanism& mechanism,
                                                       const MotionNetwork& network,
                                                       int input,
                                                       int output);

}  // namespace kinestat
