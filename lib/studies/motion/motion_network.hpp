// A mechanism prepared for finite motion: coordinates along a spanning tree, and what closes it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "couplings/finite_law.hpp"
#include "mechanism/couplings/drawn_coupling_binder.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Why a coupling, and so the mechanism, cannot be moved finitely.
enum class MotionObstacle {
  unknown_profile,    ///< a contact of which only the point and the normal are known
  no_carrier,         ///< teeth whose axes no body holds apart
  several_screws,     ///< type screws with several freedoms, whose order is not known
  spatial_cable,      ///< a cable whose pulleys leave its plane, or whose sense is not known
  undriven_position,  ///< a driven freedom that has no position: of a ball, of a contact
  drives_in_circuit   ///< the driven couplings form a circuit of their own
};

/// A sentence's end: "its profiles are not known".
std::string_view reason_of(MotionObstacle why);

struct UnmovableCoupling {
  CouplingId coupling;
  MotionObstacle why = MotionObstacle::unknown_profile;
};

/// One step from a frame to the next: about or along a line fixed in the frame before, or about a
/// point. Its coordinate is that of the freedom, of the head relative to the tail, in radians or
/// lengths of the network; of a ball the quaternion w, x, y, z of the head relative to the tail.
struct MotionJoint {
  int parent = 0;             ///< frame before
  ElementaryMotion motion;    ///< in the drawn position [m]
  double sense = 1.0;         ///< -1: from the head to the tail
  int coordinate = -1;        ///< its first; -1: it stands still and only shifts
  int rate = -1;              ///< its first; a ball has three, about axes fixed in the tail
  int freedom = -1;           ///< index into Topology::freedoms, of a ball its first; -1: none
  Vec3 shift = Vec3::Zero();  ///< of one that stands still: closure error of the drawing [m]
};

/// Teeth that roll: Σ factor · coordinate = 0. All turns and slides of a gear relative to the
/// carrier are on one line, so that they add up.
struct RollingRow {
  CouplingId coupling;
  BodyId carrier;          ///< in which the teeth touch at a fixed point
  std::vector<int> rates;  ///< of turns and slides, whose coordinates are meant
  std::vector<double> factors;
  std::vector<double> freedom_factors;  ///< Σ factor · coordinate is the position of its freedom
};

/// A condition between two frames.
struct ClosureRow {
  CouplingId coupling;
  ClosureCondition condition;  ///< [m]
  int tail_frame = 0;
  int head_frame = 0;
  int angle = -1;  ///< its first angle that is followed over full turns; -1: none
};

/// The position of a freedom of a coupling outside the tree.
struct MeasuredFreedom {
  int freedom = 0;  ///< index into Topology::freedoms
  FreedomMeasure measure;
  int tail_frame = 0;
  int head_frame = 0;
  int angle = -1;  ///< of a turn: that is followed over full turns
};

/// The cable on a pulley between two straight segments: its arc is as drawn, and what the second
/// segment has turned more than the first, seen from the pulley.
struct ContactArc {
  int contact = 0;     ///< index into Mechanism::contacts
  int arrives = 0;     ///< the followed angle of the segment before it
  int leaves = 0;      ///< that of the segment behind it
  double sense = 1.0;  ///< -1: the cable turns about -z
  double drawn = 0.0;  ///< the arc in the drawn position, with full turns [rad]

  /// The arc with these followed angles; `first` are those of the drawn position.
  double at(std::span<const double> angles, std::span<const double> first) const {
    const auto turned = [&](int angle) {
      const auto i = static_cast<std::size_t>(angle);
      return angles[i] - first[i];
    };
    return drawn + sense * (turned(leaves) - turned(arrives));
  }
};

/// Turns freely about a point; its three freedoms are turns about the world axes.
struct BallFreedoms {
  int first_freedom = 0;  ///< index into Topology::freedoms
  int tail_frame = 0;
  int head_frame = 0;
};

/// How far the two sides of a coupling are apart, the part that it does not free.
struct CouplingMiss {
  CouplingId coupling;
  double distance = 0.0;  ///< [m]
  double angle = 0.0;     ///< [rad]
};

/// Frame 0 is the ground. Lengths in m, points from the origin of the mechanism.
struct MotionNetwork {
  Space space = Space::spatial;
  double length = 1.0;               ///< [m]
  std::vector<double> part_lengths;  ///< of each freedom: the size of its part, which only the
                                     ///< ground joins to others [m]
  int frame_count = 1;
  int coordinate_count = 0;
  int rate_count = 0;
  std::vector<int> frame_of_body;   ///< of each body
  std::vector<MotionJoint> joints;  ///< joint j makes frame j + 1; parents come first
  std::vector<ClosureRow> closures;
  std::vector<RollingRow> rollings;
  std::vector<MeasuredFreedom> measures;
  std::vector<BallFreedoms> balls;
  std::vector<ContactArc> arcs;
  int angle_count = 0;                ///< angles that are followed over full turns
  std::vector<int> driven_freedoms;   ///< as they were given
  std::vector<int> driven_rates;      ///< parallel: the rate that each drives
  std::vector<VecX> passive_motions;  ///< rates of the joints: of freedoms that no other body feels
  std::vector<int> passive_freedoms;  ///< of each, the freedom that moves most
  std::vector<CouplingMiss> drawn_misses;    ///< of points not assembled, above rounding
  std::vector<UnmovableCoupling> obstacles;  ///< empty: it can be moved

  bool is_movable() const { return obstacles.empty(); }
};

/// The spanning tree holds the driven couplings, then those with few freedoms; bodies that only
/// contacts, teeth and cables hold hang on the ground by a free motion. `drawn` is parallel to the
/// couplings of the topology.
MotionNetwork make_motion_network(const Mechanism& mechanism,
                                  std::span<const DrawnCoupling> drawn,
                                  std::span<const int> driven_freedoms);

}  // namespace kinestat
