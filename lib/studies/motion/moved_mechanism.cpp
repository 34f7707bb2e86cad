#include "studies/motion/moved_mechanism.hpp"

#include <cmath>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "mechanism/cables/capstan.hpp"
#include "mechanism/cases/moved_load.hpp"
#include "studies/motion/internal/coupling_poses.hpp"

namespace kinestat {

namespace {

class MechanismMover {
 public:
  MechanismMover(const MotionNetwork& network,
                 std::span<const DrawnCoupling> drawn,
                 const Configuration& configuration,
                 std::span<const BodyPose> poses,
                 const Mechanism& mechanism)
      : network_(network),
        drawn_(drawn),
        poses_(poses),
        arcs_(contact_arcs(network, configuration)),
        mechanism_(mechanism) {}

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
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      move_contact(network_.arcs[i].contact, arcs_[i], moved);
    }
    for (std::size_t c = 0; c < moved.cases.size(); ++c) {
      for (std::size_t l = 0; l < moved.cases[c].loads.size(); ++l) {
        const Load& drawn = mechanism_.cases[c].loads[l];
        moved.cases[c].loads[l].point = moved_point(drawn.point, pose(drawn.acts.body));
        moved.cases[c].loads[l].acts.wrench = moved_wrench(drawn, pose(drawn.acts.body));
      }
      for (std::size_t l = 0; l < moved.cases[c].moving_loads.size(); ++l) {
        const MovingLoad& drawn = mechanism_.cases[c].moving_loads[l];
        move_load(drawn, pose(drawn.body), moved.cases[c].moving_loads[l]);
      }
    }
  }

 private:
  const BodyPose& pose(BodyId body) const { return poses_[at(body.value)]; }

  CouplingPoses poses_of(int e) const {
    return kinestat::poses_of(network_, mechanism_.topology, poses_, CouplingId{e});
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
    geometry.other_flanks[i].screw = poses_of(e).carrier.moved(drawn.screw);
  }

  void move_contact(int contact, double arc, Mechanism& moved) const {
    const CableContact& drawn = mechanism_.contacts[at(contact)];
    moved.contacts[at(contact)].wrap = arc;
    if (!drawn.slips || !drawn.friction) {
      return;
    }
    for (std::size_t f = 0; f < moved.frictions.size(); ++f) {
      for (std::size_t r = 0; r < moved.frictions[f].cables.size(); ++r) {
        CableFriction& cable = moved.frictions[f].cables[r];
        if (cable.slips && cable.arrives == drawn.arrives && cable.leaves == drawn.leaves) {
          cable.ratio = mechanism_.frictions[f].cables[r].ratio *
                        capstan_ratio(*drawn.friction, arc - *drawn.wrap);
        }
      }
    }
  }

  const MotionNetwork& network_;
  std::span<const DrawnCoupling> drawn_;
  std::span<const BodyPose> poses_;
  std::vector<double> arcs_;
  const Mechanism& mechanism_;
};

}  // namespace

void move_mechanism(const MotionNetwork& network,
                    std::span<const DrawnCoupling> drawn,
                    const Configuration& configuration,
                    std::span<const BodyPose> poses,
                    const Mechanism& mechanism,
                    Mechanism& moved) {
  KINESTAT_EXPECTS(poses.size() == mechanism.topology.bodies.size());
  MechanismMover(network, drawn, configuration, poses, mechanism).move(moved);
}

}  // namespace kinestat
