// What a simulation is asked for, in numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/source.hpp"

namespace kinestat {

/// A freedom as the file names it: an actuator, or coupling.freedom.
struct NamedFreedom {
  int freedom = 0;  ///< index into Topology::freedoms
  std::string name;
  SourceRange where;
};

/// Where a freedom begins [rad or m, from the drawn position] and how fast.
struct SimulationStart {
  NamedFreedom of;
  double position = 0.0;
  double speed = 0.0;  ///< [rad/s or m/s]
};

/// A freedom that something keeps at a steady speed, whatever that takes.
struct HeldFreedom {
  NamedFreedom of;
  double speed = 0.0;
};

/// The simulation ends when a freedom comes to that place, or to that speed.
struct SimulationGoal {
  NamedFreedom of;
  bool is_speed = false;
  double value = 0.0;
};

/// A freedom that goes no farther than that.
struct SimulationStop {
  NamedFreedom of;
  double place = 0.0;        ///< [rad or m, from the drawn position]
  double side = 1.0;         ///< 1: positions are below it, -1: above
  double restitution = 0.0;  ///< speed after by speed before an impact
};

struct SimulationPlan {
  std::vector<SimulationStart> starts;
  std::vector<HeldFreedom> held;
  std::vector<SimulationGoal> goals;
  std::vector<SimulationStop> stops;
  double duration = 0.0;   ///< [s]
  int steps = 0;           ///< of the rows, equal in time
  double tolerance = 0.0;  ///< of a step of the integration
  SourceRange where;
};

}  // namespace kinestat
