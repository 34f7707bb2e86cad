#include "studies/motion/task/columns/reaction_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "couplings/kinds.hpp"
#include "mechanism/couplings/coupling_reactions.hpp"
#include "studies/motion/task/friction_turns.hpp"

namespace kinestat {

namespace {

const StaticSolution* actions_at(const MotionPosition& at) {
  return at.solved && at.solved->action && !at.solved->action->wrenches.empty()
             ? &*at.solved->action
             : nullptr;
}

// The force by which the tail of a coupling acts on its head, without that of its actuators.
std::optional<Vec3> force_of(const Topology& topology, const MotionPosition& at, CouplingId id) {
  const StaticSolution& action = at.solved->action.value();
  const std::optional<Wrench>& wrench = action.wrenches[static_cast<std::size_t>(id.value)];
  if (!wrench) {
    return std::nullopt;
  }
  const CouplingTopology& coupling = topology.coupling(id);
  Vec3 force = wrench->force;
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    const auto i = static_cast<std::size_t>(a);
    const int actuator = topology.actions[i].actuator;
    if (actuator >= 0) {
      force -= action.magnitudes[i].value_or(0.0) *
               at.drive_directions[static_cast<std::size_t>(actuator)];
    }
  }
  return force;
}

std::optional<Vec3> reaction_force(const CouplingReaction& reaction,
                                   const Topology& topology,
                                   const MotionPosition& at) {
  return actions_at(at) == nullptr
             ? std::nullopt
             : resultant_force(reaction, topology, at.state.poses, [&](CouplingId other) {
                 return force_of(topology, at, other);
               });
}

// Whatever its friction, it takes no power there.
bool rests(const Topology& topology, const MotionPosition& at, CouplingId id) {
  if (!at.solved || !at.solved->motion || at.solved->motion->rates.empty()) {
    return false;
  }
  const std::vector<double>& known = at.solved->motion->rates;
  const std::vector<std::optional<double>> rates(known.begin(), known.end());
  return sliding_of(topology, id, rates).isZero(0.0);
}

class ReactionReadings {
 public:
  ReactionReadings(const FileUnits& units, const Mechanism& mechanism)
      : units_(units), mechanism_(mechanism), topology_(mechanism.topology) {}

  std::vector<MotionReading> run() {
    const std::vector<CouplingReaction> reactions = coupling_reactions(mechanism_);
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingId id{e};
      const auto bearing = std::ranges::find(reactions, id, &CouplingReaction::coupling);
      if (bearing != reactions.end()) {
        add_force(*bearing);
      }
      const auto has_friction = [&](const auto& one) { return one.coupling == id; };
      if (std::ranges::any_of(mechanism_.frictions, has_friction)) {
        add_friction(id);
      }
    }
    return std::move(readings_);
  }

 private:
  void add(CouplingId id,
           std::string_view quantity,
           QuantityKind kind,
           std::function<std::optional<double>(const MotionPosition&)> value) {
    readings_.push_back({.column = {.element = topology_.coupling(id).name,
                                    .quantity = std::string(quantity),
                                    .unit = units_.text(kind)},
                         .kind = kind,
                         .value = std::move(value),
                         .is_size = true});
  }

  void add_force(const CouplingReaction& reaction) {
    add(reaction.coupling,
        kReactionForce,
        QuantityKind::force,
        [&topology = topology_, reaction](const MotionPosition& at) {
          const std::optional<Vec3> force = reaction_force(reaction, topology, at);
          return force ? std::optional(force->norm()) : std::nullopt;
        });
  }

  // Its friction in the list of a solved case; that of couplings at rest is not there.
  static std::optional<std::size_t> find_friction(const MotionPosition& at, CouplingId id) {
    const StaticSolution* const action = actions_at(at);
    if (action == nullptr) {
      return std::nullopt;
    }
    const auto found = std::ranges::find_if(action->friction, [&](const FrictionAction& one) {
      return one.coupling == id && !one.between;
    });
    return found == action->friction.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - action->friction.begin()));
  }

  void add_friction(CouplingId id) {
    add(id,
        kReactionFriction,
        is_couple(kind_of(topology_.coupling(id).type).friction) ? QuantityKind::moment
                                                                 : QuantityKind::force,
        [id](const MotionPosition& at) -> std::optional<double> {
          const StaticSolution* const action = actions_at(at);
          if (action == nullptr || std::ranges::count(action->open_friction, id) > 0) {
            return std::nullopt;
          }
          const auto found = find_friction(at, id);
          return found ? action->friction[*found].magnitude : 0.0;
        });
    readings_.back().is_of_friction = true;
    add(id,
        kReactionLoss,
        QuantityKind::power,
        [id, &topology = topology_](const MotionPosition& at) -> std::optional<double> {
          if (rests(topology, at, id)) {
            return 0.0;
          }
          const auto found = find_friction(at, id);
          return found && at.solved->power ? std::optional(-at.solved->power->friction[*found])
                                           : std::nullopt;
        });
  }

  const FileUnits& units_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  std::vector<MotionReading> readings_;
};

}  // namespace

std::vector<MotionReading> reaction_readings(const FileUnits& units, const Mechanism& mechanism) {
  return ReactionReadings(units, mechanism).run();
}

std::vector<std::optional<Vec3>> reaction_forces(const std::vector<CouplingReaction>& reactions,
                                                 const Topology& topology,
                                                 const MotionPosition& position) {
  std::vector<std::optional<Vec3>> forces;
  for (const CouplingReaction& one : reactions) {
    forces.push_back(reaction_force(one, topology, position));
  }
  return forces;
}

}  // namespace kinestat
