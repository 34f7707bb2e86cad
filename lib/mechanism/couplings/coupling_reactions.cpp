#include "mechanism/couplings/coupling_reactions.hpp"

#include "mechanism/gears/planet_load.hpp"

namespace kinestat {

namespace {

bool bears_force(const Topology& topology, const CouplingTopology& coupling) {
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    const ActionLabel& action = topology.actions[static_cast<std::size_t>(a)];
    if (!action.is_couple && action.actuator < 0) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<CouplingReaction> coupling_reactions(const Mechanism& mechanism) {
  const std::vector<std::optional<CentralHinge>> central = find_central_hinges(mechanism);
  std::vector<CouplingReaction> reactions;
  for (int e = 0; e < mechanism.topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = mechanism.topology.coupling(CouplingId{e});
    if (bears_force(mechanism.topology, coupling)) {
      reactions.push_back({.coupling = CouplingId{e},
                           .hinge = central[static_cast<std::size_t>(e)],
                           .share = most_loaded_share(mechanism, coupling)});
    }
  }
  return reactions;
}

std::optional<Vec3> resultant_force(const CouplingReaction& reaction,
                                    const Topology& topology,
                                    std::span<const BodyPose> poses,
                                    const ReactionForceOf& force_of) {
  std::optional<CentralHinge> moved = reaction.hinge;
  if (moved) {  // its axis is fixed in the tail of its coupling
    const BodyId tail = topology.coupling(reaction.coupling).tail;
    moved->axis = poses[static_cast<std::size_t>(tail.value)].rotation * moved->axis;
  }
  const std::optional<Vec3> force = borne_force(moved, reaction.coupling, force_of);
  return force ? std::optional<Vec3>(reaction.share * *force) : std::nullopt;
}

}  // namespace kinestat
