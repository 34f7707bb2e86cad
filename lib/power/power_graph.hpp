// The flow of power from body to body in one case, and whether power circulates.
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
  double power = 0.0;  ///< [W], positive: the smaller of what leaves `from` and what reaches `to`
  double bound = 0.0;  ///< error bound of the power [W]
};

/// The power that a body receives and gives through its couplings and loads [W]. The two are equal
/// if the powers balance.
struct BodyPower {
  double received = 0.0;
  double given = 0.0;
};

/// The flow of power as seen from the ground, so that a train that turns as a block transmits power
/// too. Couplings whose wrench is open are left out, and so are the balances of their bodies.
struct PowerGraph {
  std::vector<PowerArc> arcs;  ///< in the order of the couplings
  /// The powers from shaft to shaft. Planets that mesh with each other on one carrier are one
  /// shaft, which the first of them represents. The strands of a belt count as one arc. Several
  /// couplings between two shafts count as one, under the name of the strongest. A gear on a fixed
  /// axis gives its torque times its speed, and so do the bearings of all planets for their
  /// carrier: nothing here depends on pressure angles or on where the planets are drawn.
  std::vector<PowerArc> net;
  std::vector<std::optional<BodyPower>> bodies;  ///< of each body; zeros for the ground, at rest
  std::vector<MeshPower> meshes;                 ///< of the meshes whose carrier is known
  std::vector<CirculatingPower> circulating;
  /// The recirculation factor γ by find_recirculation; empty without input.
  std::optional<double> recirculation;
};

/// Finds the flow of power. `flow` must have the powers of this motion and these actions.
PowerGraph find_power_graph(const Mechanism& mechanism,
                            const Case& which,
                            const KinematicSolution& motion,
                            const StaticSolution& action,
                            const PowerFlow& flow);

}  // namespace kinestat
