// What meshes lose, as couples between gears and their carriers.
#pragma once

#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// The loss of one mesh that rolls: seen from the carrier the driven one of its gears is held back
/// by a couple, the carrier being the other body of it, whose power is the loss (1 - η) of what the
/// driving gear gives. Which of them drives follows from the force of the teeth. Each law has one
/// pressing part; its first component is the power that it is a share of over the speed of the
/// gear, negative where the other gear is the driven one, and the magnitude is linear in it.
struct MeshLossLaw {
  FrictionLaw head_driven;
  FrictionLaw tail_driven;
  const LossyMesh* lossy = nullptr;  ///< in the mechanism; its share may depend on speed and force
  double radius = 0.0;  ///< of the head's pitch circle: the speed of the pitch point in the carrier
                        ///< by that of the head [m]
  int planets = 1;      ///< that share the force
};

/// Of all lossy meshes in a case with some motion. A mesh that does not roll in its carrier, as in
/// a train that turns as a block, loses nothing.
struct MeshLossLaws {
  std::vector<MeshLossLaw> laws;            ///< in the order of mechanism.lossy_meshes
  std::vector<CouplingId> not_rolling;      ///< likewise
  std::vector<CouplingId> without_carrier;  ///< likewise; their loss cannot be told
};

MeshLossLaws find_mesh_loss_laws(const Mechanism& mechanism, const KinematicSolution& motion);

}  // namespace kinestat
