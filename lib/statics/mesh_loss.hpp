// What meshes lose, as couples between gears and their carriers.
#pragma once

#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

/// The laws of all lossy meshes in a case with that motion. A mesh that rolls in its carrier has
/// two: seen from the carrier the driven gear of the two is held back by a couple, the carrier
/// being its other body, whose power is the loss (1 - η) of what the driving gear gives. Which of
/// them drives follows from the force of the teeth, so that one of the laws is always idle. A mesh
/// that does not roll, as in a train that turns as a block, has none.
struct MeshLossLaws {
  std::vector<FrictionLaw> laws;
  std::vector<CouplingId> without_carrier;  ///< lossy meshes whose carrier is not known
};

MeshLossLaws find_mesh_loss_laws(const Mechanism& mechanism, const KinematicSolution& motion);

}  // namespace kinestat
