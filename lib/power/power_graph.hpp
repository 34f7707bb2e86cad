// Which way the power goes from body to body in one case, and whether it circulates.
#pragma once

#include <optional>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "power/circulating_power.hpp"
#include "power/mesh_power.hpp"
#include "power/power_flow.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Power that a coupling transmits from one body to another.
struct PowerArc {
  CouplingId coupling;
  BodyId from;
  BodyId to;
  double power =
      0.0;  ///< [W], positive: what leaves `from` and what reaches `to`, whichever is less
  double bound = 0.0;  ///< by how much it may be off [W]
};

/// What a body gets and gives through its couplings and loads [W]; in balance they are equal.
struct BodyPower {
  double received = 0.0;
  double given = 0.0;
};

/// Seen from the ground, so that a train that turns as a block carries power too. Couplings whose
/// wrench is open are left out, and with them the balance of their bodies.
struct PowerGraph {
  std::vector<PowerArc> arcs;  ///< in the order of the couplings
  /// What goes from shaft to shaft: planets that mesh with each other on one carrier are one, which
  /// the first of them stands for, the strands of a belt are one, and of several couplings between
  /// the same two the strongest stands for their sum. A gear on a fixed axis gives torque times
  /// speed, and the bearings of the planets together the carrier's; so nothing here depends on
  /// pressure angles, nor on where the planets are drawn.
  std::vector<PowerArc> net;
  std::vector<std::optional<BodyPower>> bodies;  ///< of all bodies; the ground, at rest, has zeros
  std::vector<MeshPower> meshes;                 ///< those whose carrier is known
  std::vector<CirculatingPower> circulating;
  /// γ: what find_recirculation says of `net`, if there is an input.
  std::optional<double> recirculation;
};

/// The flow must be that of the motion and the actions.
PowerGraph find_power_graph(const Mechanism& mechanism,
                            const Case& which,
                            const KinematicSolution& motion,
                            const StaticSolution& action,
                            const PowerFlow& flow);

}  // namespace kinestat
