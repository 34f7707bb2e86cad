// What a transmission with lossy meshes passes on, forwards and backwards.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "power/efficiency.hpp"
#include "power/power_graph.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// One case with losses. Both models are found, whichever the file prefers.
struct TransmissionEfficiency {
  /// Losses by the power that rolls in the carrier of each mesh (Macmillan; Pennestrì and
  /// Freudenstein 1993): the power that is latent in a train that turns as a block is not lost.
  Efficiency carrier;
  Efficiency carrier_backward;  ///< the same motion with all known actions and loads reversed: the
                                ///< outputs drive
  Efficiency absolute;          ///< losses by the power through each mesh as seen from the ground
                                ///< (Cazangi 2008, section 4.4.4)
  std::vector<FrictionAction> losses;          ///< of the meshes that roll, in the carrier model
  std::vector<double> loss_powers;             ///< of them [W], negative
  std::vector<std::optional<double>> actions;  ///< of each action, with the losses of that model;
                                               ///< empty where it locks
};

/// Of a case that is solved without the losses of meshes: `power` and `graph` must be its flow. The
/// laws are those of its couplings and then those of its meshes; the basis must hold their
/// wrenches.
TransmissionEfficiency find_transmission_efficiency(const Mechanism& mechanism,
                                                    const CoordinateBasis& basis,
                                                    const Case& which,
                                                    const KinematicSolution& motion,
                                                    std::span<const FrictionLaw> laws,
                                                    const PowerFlow& power,
                                                    const PowerGraph& graph);

}  // namespace kinestat
