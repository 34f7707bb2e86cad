#include "motion/moved_mechanism.hpp"

#include <cmath>
#include <numbers>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "mechanism/moved_coupling.hpp"

namespace kinestat {

namespace {

class MechanismMover {
 public:
  MechanismMover(const MotionNetwork& network,
                 std::span<const DrawnCoupling> drawn,
                 std::span<const BodyPose> poses,
                 const Mechanism& mechanism)
      : network_(network), drawn_(drawn), poses_(poses), mechanism_(mechanism) {}

  void move(Mechanism& moved) const {
    for (int e = 0; e < mechanism_.topology.coupling_count(); ++e) {
      move_coupling(e, moved.geometry);
    }
    for (std::size_t i = 0; i < moved.geometry.other_flanks.size(); ++i) {
      move_flank(i, moved.geometry);
    }
    for (std::size_t b = 0; b < poses_.size(); ++b) {
      moved.geometry.references[b] = poses_[b].point(mechanism_.geometry.references[b]);
    }
    for (std::size_t i = 0; i < moved.contacts.size(); ++i) {
      move_contact(i, moved);
    }
    for (std::size_t c = 0; c < moved.cases.size(); ++c) {
      for (std::size_t l = 0; l < moved.cases[c].loads.size(); ++l) {
        move_load(mechanism_.cases[c].loads[l], moved.cases[c].loads[l]);
      }
    }
  }

 private:
  const BodyPose& pose(BodyId body) const { return poses_[at(body.value)]; }

  CouplingPoses poses_of(int e) const {
    const CouplingTopology& coupling = mechanism_.topology.coupling({e});
    CouplingPoses result = {
        .tail = pose(coupling.tail), .head = pose(coupling.head), .carrier = {}};
    for (const RollingRow& rolling : network_.rollings) {
      if (rolling.coupling.value == e) {
        result.carrier = pose(rolling.carrier);
      }
    }
    return result;
  }

  void move_coupling(int e, Geometry& geometry) const {
    const CouplingTopology& coupling = mechanism_.topology.coupling({e});
    const MovedCoupling moved = moved_coupling(mechanism_, {e}, drawn_[at(e)], poses_of(e));
    std::copy(moved.motions.begin(),
              moved.motions.end(),
              geometry.motions.begin() + coupling.first_freedom);
    std::copy(moved.actions.begin(),
              moved.actions.end(),
              geometry.actions.begin() + coupling.first_action);
    geometry.points[at(e)] = moved.point;
  }

  void move_flank(std::size_t i, Geometry& geometry) const {
    const OtherFlankOf<double>& drawn = mechanism_.geometry.other_flanks[i];
    const int e = mechanism_.topology.actions[at(drawn.action)].coupling.value;
    BodyPose carrier = poses_of(e).carrier;
    // About the origin of the geometry instead of that of the world.
    carrier.shift = carrier.point(mechanism_.geometry.origin) - mechanism_.geometry.origin;
    geometry.other_flanks[i].screw = carrier.moved(drawn.screw);
  }

  // Full turns of the rope stay; so does which side of a straight rope the pulley is on.
  void move_contact(std::size_t i, Mechanism& moved) const {
    const CableContact& drawn = mechanism_.contacts[i];
    if (!drawn.wrap) {
      return;
    }
    const auto wrap = [&](const Geometry& geometry) {
      const CableStationGeometry& station = *drawn_[at(drawn.leaves.value)].from;
      const BodyId body = mechanism_.topology.coupling(drawn.leaves).tail;
      const CableStationGeometry pulley =
          &geometry == &mechanism_.geometry ? station : moved_station(station, pose(body));
      return wrap_angle<double>(
          pulley, span_of(drawn.arrives, geometry), span_of(drawn.leaves, geometry));
    };
    const double change = wrap(moved.geometry) - wrap(mechanism_.geometry);
    moved.contacts[i].wrap = *drawn.wrap + change;
    for (std::size_t f = 0; f < moved.frictions.size(); ++f) {
      for (std::size_t r = 0; r < moved.frictions[f].ropes.size(); ++r) {
        RopeFriction& rope = moved.frictions[f].ropes[r];
        if (drawn.slips && drawn.friction && rope.arrives == drawn.arrives &&
            rope.leaves == drawn.leaves) {
          rope.ratio = mechanism_.frictions[f].ropes[r].ratio * std::exp(*drawn.friction * change);
        }
      }
    }
  }

  CableSpan span_of(CouplingId segment, const Geometry& geometry) const {
    const DrawnCoupling& drawn = drawn_[at(segment.value)];
    const CouplingTopology& coupling = mechanism_.topology.coupling(segment);
    if (&geometry == &mechanism_.geometry) {
      return {.from = drawn.geometry.from, .to = drawn.geometry.to};
    }
    return tangent_span<double>(moved_station(*drawn.from, pose(coupling.tail)),
                                moved_station(*drawn.to, pose(coupling.head)));
  }

  void move_load(const Load& drawn, Load& moved) const {
    if (!drawn.point) {
      return;
    }
    const Vec3 origin = mechanism_.geometry.origin;
    const Vec3 couple = couple_of(drawn, origin);
    const Vec3 point = pose(drawn.acts.body).point(*drawn.point);
    moved.point = point;
    moved.acts.wrench.moment = (point - origin).cross(drawn.acts.wrench.force) + couple;
  }

  const MotionNetwork& network_;
  std::span<const DrawnCoupling> drawn_;
  std::span<const BodyPose> poses_;
  const Mechanism& mechanism_;
};

}  // namespace

void move_mechanism(const MotionNetwork& network,
                    std::span<const DrawnCoupling> drawn,
                    std::span<const BodyPose> poses,
                    const Mechanism& mechanism,
                    Mechanism& moved) {
  KINESTAT_EXPECTS(poses.size() == mechanism.topology.bodies.size());
  MechanismMover(network, drawn, poses, mechanism).move(moved);
}

}  // namespace kinestat
