#include "statics/mesh_loss.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "mechanism/mesh.hpp"

namespace kinestat {

namespace {

// Power of a wrench as a linear form: power = row * wrench.
Eigen::Matrix<double, 1, 6> power_on(const Twist& twist) {
  Eigen::Matrix<double, 1, 6> row;
  row << twist.angular.transpose(), twist.linear.transpose();
  return row;
}

class LossLaws {
 public:
  LossLaws(const Mechanism& mechanism, const KinematicSolution& motion)
      : mechanism_(mechanism), motion_(motion) {
    for (const Twist& twist : motion.bodies) {
      fastest_ = std::max(fastest_, twist.angular.norm());
    }
  }

  // Of one of the two gears, where the mesh drives it: `sign` times the power into the head is then
  // positive.
  void add(const LossyMesh& mesh, BodyId carrier, BodyId gear, double sign) {
    const CouplingTopology& coupling = mechanism_.topology.coupling(mesh.coupling);
    const Twist rolling = twist_of(coupling.head) - twist_of(carrier);
    const Vec3 turning = (twist_of(gear) - twist_of(carrier)).angular;
    const double speed = turning.norm();
    if (speed <= kReportZero * fastest_) {
      return;
    }
    FrictionLaw law;
    law.coupling = mesh.coupling;
    law.between = BodyPair{.tail = carrier, .head = gear};
    law.unit = unit_couple(Vec3(-turning / speed));
    law.speed = speed;
    PressingPart part;
    part.part.row(0) = sign / speed * power_on(rolling);
    part.weight = mesh.share;
    part.weight_if_negative = 0.0;
    part.is_signed = true;
    law.parts = {part};
    result.laws.push_back(law);
  }

  MeshLossLaws result;

 private:
  const Twist& twist_of(BodyId body) const {
    return motion_.bodies[static_cast<std::size_t>(body.value)];
  }

  const Mechanism& mechanism_;
  const KinematicSolution& motion_;
  double fastest_ = 0.0;
};

}  // namespace

MeshLossLaws find_mesh_loss_laws(const Mechanism& mechanism, const KinematicSolution& motion) {
  LossLaws laws(mechanism, motion);
  if (mechanism.lossy_meshes.empty()) {
    return std::move(laws.result);
  }
  const std::vector<Mesh> meshes = find_meshes(mechanism.topology, mechanism.geometry);
  for (const LossyMesh& lossy : mechanism.lossy_meshes) {
    const auto mesh = std::ranges::find(meshes, lossy.coupling, &Mesh::coupling);
    KINESTAT_EXPECTS(mesh != meshes.end());
    if (!mesh->carrier) {
      laws.result.without_carrier.push_back(lossy.coupling);
      continue;
    }
    const CouplingTopology& coupling = mechanism.topology.coupling(lossy.coupling);
    laws.add(lossy, *mesh->carrier, coupling.head, 1.0);
    laws.add(lossy, *mesh->carrier, coupling.tail, -1.0);
  }
  return std::move(laws.result);
}

}  // namespace kinestat
