// The power of teeth in the frame of their carrier, which losses are a share of.
#pragma once

#include <span>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/gears/mesh.hpp"
#include "mechanism/mechanism.hpp"
#include "power/power_flow.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Teeth seen from their carrier, where only what rolls transmits power.
struct MeshPower {
  CouplingId coupling;
  BodyId carrier;
  double rolling = 0.0;  ///< into the head in the carrier's frame [W]; |rolling| is what losses of
                         ///< the mesh are a share of (rolling, latent or potential power)
};

/// Of those of `meshes` whose carrier is known and whose wrench is not open.
std::vector<MeshPower> find_mesh_powers(const Mechanism& mechanism,
                                        const KinematicSolution& motion,
                                        const StaticSolution& action,
                                        const PowerFlow& flow,
                                        std::span<const Mesh> meshes);

}  // namespace kinestat
