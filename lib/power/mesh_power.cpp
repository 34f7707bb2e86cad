#include "power/mesh_power.hpp"

#include "kinematics/bounded_motion.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

std::vector<MeshPower> find_mesh_powers(const Mechanism& mechanism,
                                        const KinematicSolution& motion,
                                        const StaticSolution& action,
                                        const PowerFlow& flow,
                                        std::span<const Mesh> meshes) {
  std::vector<MeshPower> result;
  for (const Mesh& mesh : meshes) {
    if (mesh.carrier && flow.into_head[static_cast<std::size_t>(mesh.coupling.value)]) {
      const BodyId head = mechanism.topology.coupling(mesh.coupling).head;
      const BoundedTwist on_carrier =
          bounded_body(motion, head) - bounded_body(motion, *mesh.carrier);
      const BoundedNumber rolling = power(*bounded_wrench(action, mesh.coupling), on_carrier);
      result.push_back(
          {.coupling = mesh.coupling, .carrier = *mesh.carrier, .rolling = rolling.zeroed()});
    }
  }
  return result;
}

}  // namespace kinestat
