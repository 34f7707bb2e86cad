// The efficiency of a transmission with lossy meshes, forwards and backwards.
#pragma once

#include <optional>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "power/efficiency.hpp"
#include "power/power_graph.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// The loss of a mesh in the carrier model.
struct MeshLossPower {
  CouplingId mesh;
  bool rolls = true;             ///< whether it rolls in its carrier; else it loses nothing
  std::optional<BodyId> driven;  ///< the gear that the loss holds back; empty if nothing is lost
  double couple = 0.0;           ///< the couple that holds it back [N·m]
  double power = 0.0;            ///< the power of this couple [W], never positive
};

/// The losses in the carrier model, and the actions with these losses.
struct LossyState {
  std::vector<MeshLossPower> meshes;           ///< in the order of mechanism.lossy_meshes
  std::vector<double> friction;                ///< powers of the friction of couplings [W], in the
                                               ///< order of the friction of the case
  std::vector<std::optional<double>> actions;  ///< of each action [N·m or N]
  std::vector<double> actuators;               ///< of each actuator: its power [W]
  double input = 0.0;                          ///< as in a PowerFlow [W]
  double balance_residual = 0.0;  ///< |sum of the powers of actuators, loads and losses| relative
                                  ///< to the largest of them
};

/// The efficiencies of one case with losses, by both models, whichever the file prefers. All of
/// them include the friction of couplings.
struct TransmissionEfficiency {
  /// With losses by the power that rolls relative to the carrier of each mesh (Macmillan 1961;
  /// Pennestrì and Freudenstein 1993): a train that turns as a block loses nothing. Self-locking if
  /// no senses of the losses agree with power that leaves at the outputs.
  Efficiency carrier;
  /// With the same known actions and loads and all motion reversed, so that the outputs drive.
  Efficiency carrier_backward;
  /// With losses by the power through each mesh, seen from the ground (Cazangi 2008, 4.4.4, p.
  /// 88).
  Efficiency absolute;
  std::optional<LossyState> state;  ///< forwards; empty if the case locks or losses are open
  std::vector<CouplingId> without_carrier;  ///< lossy meshes whose carrier is not known: the
                                            ///< carrier model has no answer
};

/// A case that was solved without the losses of its meshes, but with the friction of its couplings.
/// The motion must be solved; `power` and `graph` must be those of its motion and actions.
struct SolvedCase {
  const Case& which;
  const KinematicSolution& motion;
  const PowerFlow& power;
  const PowerGraph& graph;
};

/// For a mechanism with lossy meshes. `common` is the basis of its actions without loads.
TransmissionEfficiency find_transmission_efficiency(const Mechanism& mechanism,
                                                    const CoordinateBasis& common,
                                                    const SolvedCase& solved);

}  // namespace kinestat
