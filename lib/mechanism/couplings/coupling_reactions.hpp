// What couplings bear, whatever its direction.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mechanism/gears/central_hinge.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// The quantities of a coupling that motions and simulations report of its reaction: the resultant
/// force, the couple or drag of its friction, the power that this loses.
inline constexpr std::string_view kReactionForce = "force";
inline constexpr std::string_view kReactionFriction = "friction";
inline constexpr std::string_view kReactionLoss = "loss";

/// A coupling that bears forces.
struct CouplingReaction {
  CouplingId coupling;
  std::optional<CentralHinge> hinge = {};  ///< as drawn
  double share = 1.0;  ///< that the most loaded of equal planets has of what is drawn
};

/// Those of a mechanism, in the order of its couplings.
std::vector<CouplingReaction> coupling_reactions(const Mechanism& mechanism);

/// The force by which the tail of a coupling acts on its head, with its friction and without its
/// actuators [N]; empty where equilibrium leaves it open.
using ReactionForceOf = std::function<std::optional<Vec3>(CouplingId)>;

/// The resultant force of tail on head [N]: of central hinges without the planets' part, of planets
/// that of the most loaded one. `poses` are those of the bodies.
std::optional<Vec3> resultant_force(const CouplingReaction& reaction,
                                    const Topology& topology,
                                    std::span<const BodyPose> poses,
                                    const ReactionForceOf& force_of);

}  // namespace kinestat
