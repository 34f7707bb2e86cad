// The power of meshes relative to their carriers; mesh losses are a share of it.
#pragma once

#include <span>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/gears/mesh.hpp"
#include "mechanism/mechanism.hpp"
#include "power/power_flow.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The power of a mesh relative to its carrier, where it transmits power only if it rolls.
struct MeshPower {
  CouplingId coupling;
  BodyId carrier;
  double rolling = 0.0;  ///< power into the head in the frame of the carrier [W] (rolling, latent
                         ///< or potential power); losses of the mesh are a share of |rolling|
};

/// Finds the powers of those meshes whose carrier is known and whose wrench is not open.
std::vector<MeshPower> find_mesh_powers(const Mechanism& mechanism,
                                        const KinematicSolution& motion,
                                        const StaticSolution& action,
                                        const PowerFlow& flow,
                                        std::span<const Mesh> meshes);

}  // namespace kinestat
