// The structure of a mechanism without its dimensions: bodies, couplings, freedoms and actions.
#pragma once

#include <string>
#include <vector>

#include "core/source.hpp"
#include "core/types.hpp"
#include "description/coupling_description.hpp"
#include "graph/digraph.hpp"

namespace kinestat {

struct BodyTopology {
  std::string name;
  SourceRange where;
};

/// An edge of the coupling graph. Its freedoms and its actions are consecutive in the lists of the
/// Topology; the passive constraints come before the internalised actions of its actuators.
struct CouplingTopology {
  std::string name;
  CouplingType type = CouplingType::revolute;
  BodyId tail;
  BodyId head;
  int first_freedom = 0;
  int freedom_count = 0;
  int first_action = 0;
  int action_count = 0;
  SourceRange where;

  /// Whether it is a segment of a cable with a tension, which is then its first action.
  bool bears_tension() const { return type == CouplingType::cable && action_count > 0; }
};

/// One unknown of kinematics: a column of M_N.
struct FreedomLabel {
  CouplingId coupling;
  std::string name;         ///< "wz", "vy", "w", …: unique within the coupling
  bool is_rotation = true;  ///< [rad/s], otherwise [m/s]
};

/// One unknown of statics: a column of A_N.
struct ActionLabel {
  CouplingId coupling;
  std::string name;       ///< "Rx", "Tz", …; of an internalised action the actuator's name
  bool is_couple = true;  ///< [N·m], otherwise [N]
  int actuator = -1;      ///< index of the actuator that internalises it; -1: passive constraint
};

/// An active coupling: a freedom that carries an internalised action.
struct ActuatorTopology {
  std::string name;
  int freedom = 0;  ///< index into Topology::freedoms
  int action = 0;   ///< index into Topology::actions
  SourceRange where;
};

/// The lists of a structure. The first body is the ground; couplings are in file order.
struct Topology {
  std::vector<BodyTopology> bodies;
  std::vector<CouplingTopology> couplings;
  std::vector<FreedomLabel> freedoms;
  std::vector<ActionLabel> actions;
  std::vector<ActuatorTopology> actuators;

  int body_count() const { return static_cast<int>(bodies.size()); }

  int coupling_count() const { return static_cast<int>(couplings.size()); }

  int freedom_count() const { return static_cast<int>(freedoms.size()); }

  int action_count() const { return static_cast<int>(actions.size()); }

  const CouplingTopology& coupling(CouplingId id) const {
    return couplings[static_cast<std::size_t>(id.value)];
  }

  const BodyTopology& body(BodyId id) const { return bodies[static_cast<std::size_t>(id.value)]; }

  /// "a.wz"
  std::string freedom_name(int freedom) const {
    const FreedomLabel& label = freedoms[static_cast<std::size_t>(freedom)];
    return coupling(label.coupling).name + "." + label.name;
  }

  /// "a.Rx", or the actuator's name
  std::string action_name(int action) const {
    const ActionLabel& label = actions[static_cast<std::size_t>(action)];
    return label.actuator >= 0 ? label.name : coupling(label.coupling).name + "." + label.name;
  }

  /// The freedoms that actuators drive, in the order of the actuators.
  std::vector<int> driven_freedoms() const {
    std::vector<int> driven;
    for (const ActuatorTopology& actuator : actuators) {
      driven.push_back(actuator.freedom);
    }
    return driven;
  }

  /// The actions of the actuators, in the order of the actuators.
  std::vector<int> driving_actions() const {
    std::vector<int> driving;
    for (const ActuatorTopology& actuator : actuators) {
      driving.push_back(actuator.action);
    }
    return driving;
  }

  /// Bodies as vertices, couplings as edges.
  Digraph coupling_graph() const {
    Digraph graph{.vertex_count = body_count(), .edges = {}};
    for (const CouplingTopology& edge : couplings) {
      graph.edges.push_back({.tail = edge.tail.value, .head = edge.head.value});
    }
    return graph;
  }
};

}  // namespace kinestat
