// The section `simulation`: a mechanism left to what acts on it.
#pragma once

#include <optional>
#include <vector>

#include "description/case_description.hpp"
#include "description/value.hpp"

namespace kinestat {

/// Where a freedom stands and how fast it moves; its target is an actuator, or coupling.freedom.
struct FreedomState {
  Name target;
  std::optional<Value> position = {};  ///< from the drawn position
  std::optional<Value> speed = {};
};

/// How far a freedom can go; its target likewise.
struct StopDescription {
  Name target;
  std::optional<Value> from = {};  ///< from the drawn position
  std::optional<Value> to = {};
  std::optional<Value> restitution = {};  ///< speed after by speed before an impact; 0: none
};

struct SimulationDescription {
  std::vector<Assignment> motions = {};  ///< that something holds, steadily
  std::vector<Assignment> actions = {};
  std::vector<FreedomState> start = {};
  std::vector<FreedomState> until = {};  ///< the first that is reached ends it
  std::vector<StopDescription> stops = {};
  Value time;
  std::optional<Value> steps = {};
  std::optional<Value> tolerance = {};
  std::vector<Name> report = {};  ///< `velocity`, `action`, … or names of columns
  SourceRange where;
};

/// What is known in it, as a case with inertia.
inline CaseDescription case_of(const SimulationDescription& simulation) {
  return {.label = {.text = "simulation", .where = simulation.where},
          .asks_motions = true,
          .asks_actions = true,
          .has_inertia = true,
          .motions = simulation.motions,
          .actions = simulation.actions,
          .loads = {},
          .inputs = {},
          .outputs = {}};
}

}  // namespace kinestat
