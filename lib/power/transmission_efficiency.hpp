// What a transmission with lossy meshes passes on, forwards and backwards.
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

/// What a mesh loses in the carrier model.
struct MeshLossPower {
  CouplingId mesh;
  bool rolls = true;             ///< in its carrier; else it loses nothing
  std::optional<BodyId> driven;  ///< the gear that is held back; none where nothing is lost
  double couple = 0.0;           ///< that does so [N·m]
  double power = 0.0;            ///< its power [W], never positive
};

/// What loses power in the carrier model, and what acts then.
struct LossyState {
  std::vector<MeshLossPower> meshes;           ///< in the order of mechanism.lossy_meshes
  std::vector<double> friction;                ///< powers of the friction of couplings [W], in the
                                               ///< order of the friction of the case
  std::vector<std::optional<double>> actions;  ///< of each action
  std::vector<double> actuators;               ///< powers [W], as those of a PowerFlow
  double input = 0.0;                          ///< [W], likewise
  double balance_residual = 0.0;  ///< |sum of the powers of actuators, loads and losses| relative
                                  ///< to the largest of them
};

/// One case with losses. Both models are found, whichever the file prefers; all three contain the
/// friction of couplings too.
struct TransmissionEfficiency {
  /// Losses by the power that rolls in the carrier of each mesh (Macmillan 1961; Pennestrì and
  /// Freudenstein 1993): the power that is latent in a train that turns as a block is not lost.
  /// Self-locking where no sense of the losses agrees with power that leaves by the outputs.
  Efficiency carrier;
  /// The same motion with all known actions and loads reversed: the outputs drive.
  Efficiency carrier_backward;
  /// Losses by the power through each mesh as seen from the ground (Cazangi 2008, 4.4.4, p. 88).
  Efficiency absolute;
  std::optional<LossyState> state;          ///< forwards; empty where the losses lock, or are open
  std::vector<CouplingId> without_carrier;  ///< lossy meshes whose carrier is not known: the
                                            ///< carrier model has no answer
};

/// A case that is solved without the losses of its meshes, but with the friction of its couplings.
/// The motion must be solved, and `power` and `graph` be the flow of motion and action.
struct SolvedCase {
  const Case& which;
  const KinematicSolution& motion;
  const PowerFlow& power;
  const PowerGraph& graph;
};

/// Of a mechanism with lossy meshes. `common` are the coordinates of its actions without loads.
TransmissionEfficiency find_transmission_efficiency(const Mechanism& mechanism,
                                                    const CoordinateBasis& common,
                                                    const SolvedCase& solved);

}  // namespace kinestat
