#include "statics/mesh_loss_law.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "kinematics/bounded_motion.hpp"
#include "mechanism/gears/mesh.hpp"

namespace kinestat {

namespace {

// Power of a wrench as a linear form: power = row * wrench.
Eigen::Matrix<double, 1, 6> power_on(const Twist& twist) {
  Eigen::Matrix<double, 1, 6> row;
  row << twist.angular.transpose(), twist.linear.transpose();
  return row;
}

class LawMaker {
 public:
  LawMaker(const Mechanism& mechanism, const KinematicSolution& motion)
      : mechanism_(mechanism), motion_(motion) {}

  // Empty if it does not roll.
  std::optional<MeshLossLaw> law_of(const LossyMesh& mesh, BodyId carrier) const {
    const CouplingTopology& coupling = mechanism_.topology.coupling(mesh.coupling);
    if (!turns(coupling.head, carrier) || !turns(coupling.tail, carrier)) {
      return std::nullopt;
    }
    const Twist head = twist_of(coupling.head) - twist_of(carrier);
    const Vec3& pitch_point =
        mechanism_.geometry.points[static_cast<std::size_t>(mesh.coupling.value)];
    return MeshLossLaw{
        .head_driven = law_where_driven(mesh, carrier, coupling.head, 1.0),
        .tail_driven = law_where_driven(mesh, carrier, coupling.tail, -1.0),
        .lossy = &mesh,
        .radius = velocity_at<double>(head, pitch_point).norm() / head.angular.norm(),
        .planets = mechanism_.planet_counts[static_cast<std::size_t>(coupling.first_action)]};
  }

 private:
  bool turns(BodyId gear, BodyId carrier) const {
    const BoundedTwist relative = bounded_body(motion_, gear) - bounded_body(motion_, carrier);
    return !relative.angular.zeroed().isZero(0.0);
  }

  Vec3 turning_of(BodyId gear, BodyId carrier) const {
    return (twist_of(gear) - twist_of(carrier)).angular;
  }

  double speed_of(BodyId gear, BodyId carrier) const { return turning_of(gear, carrier).norm(); }

  // `sign` times the power into the head is positive where the mesh drives that gear.
  FrictionLaw law_where_driven(const LossyMesh& mesh,
                               BodyId carrier,
                               BodyId gear,
                               double sign) const {
    const BodyId head = mechanism_.topology.coupling(mesh.coupling).head;
    FrictionLaw law;
    law.coupling = mesh.coupling;
    law.between = BodyPair{.tail = carrier, .head = gear};
    law.speed = speed_of(gear, carrier);
    law.unit = unit_couple(Vec3(-turning_of(gear, carrier) / law.speed));
    PressingPart part;
    part.part.row(0) = sign / law.speed * power_on(twist_of(head) - twist_of(carrier));
    part.weight = mesh.share;
    law.parts = {part};
    return law;
  }

  const Twist& twist_of(BodyId body) const {
    return motion_.bodies[static_cast<std::size_t>(body.value)];
  }

  const Mechanism& mechanism_;
  const KinematicSolution& motion_;
};

}  // namespace

MeshLossLaws find_mesh_loss_laws(const Mechanism& mechanism, const KinematicSolution& motion) {
  MeshLossLaws result;
  if (mechanism.lossy_meshes.empty()) {
    return result;
  }
  const LawMaker maker(mechanism, motion);
  const std::vector<Mesh> meshes = find_meshes(mechanism.topology, mechanism.geometry);
  for (const LossyMesh& lossy : mechanism.lossy_meshes) {
    const auto mesh = std::ranges::find(meshes, lossy.coupling, &Mesh::coupling);
    KINESTAT_EXPECTS(mesh != meshes.end());
    const bool loses = lossy.law || lossy.share > 0.0;
    if (!mesh->carrier) {
      if (loses) {
        result.without_carrier.push_back(lossy.coupling);
      }
      continue;
    }
    std::optional<MeshLossLaw> law = maker.law_of(lossy, *mesh->carrier);
    if (!law) {
      result.not_rolling.push_back(lossy.coupling);
    } else if (loses) {
      result.laws.push_back(*std::move(law));
    }
  }
  return result;
}

}  // namespace kinestat
