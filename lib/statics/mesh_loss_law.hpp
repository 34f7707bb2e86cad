// Losses of meshes, as couples between gears and their carriers.
#pragma once

#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// The loss of one mesh that rolls: a couple between the carrier and the driven gear that holds
/// back this gear. Relative to the carrier, its power is the share 1 - η of the power that the
/// driving gear gives. The tooth force decides which gear drives. Each law has one pressing part.
/// Its first component is the power that rolls in the mesh over the speed of the driven gear; it is
/// negative if the other gear is driven. The magnitude of the couple is proportional to it.
struct MeshLossLaw {
  FrictionLaw head_driven;
  FrictionLaw tail_driven;
  const LossyMesh* lossy = nullptr;  ///< in the mechanism; its share may depend on speed and force
  double radius = 0.0;  ///< of the pitch circle of the head [m]: the speed of the pitch point in
                        ///< the carrier over the angular velocity of the head
  int planets = 1;      ///< the number of equal planets that share the tooth force
};

/// The laws of all lossy meshes in a case with a given motion. A mesh that does not roll in its
/// carrier, as in a train that turns as a block, loses nothing.
struct MeshLossLaws {
  std::vector<MeshLossLaw> laws;            ///< in the order of mechanism.lossy_meshes
  std::vector<CouplingId> not_rolling;      ///< in the same order
  std::vector<CouplingId> without_carrier;  ///< in the same order; their loss is not known
};

MeshLossLaws find_mesh_loss_laws(const Mechanism& mechanism, const KinematicSolution& motion);

}  // namespace kinestat
