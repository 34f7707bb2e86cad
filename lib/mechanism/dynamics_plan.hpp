// The section `dynamics` bound to numbers.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

struct FlywheelPlan {
  int actuator = 0;          ///< index into Topology::actuators
  double fluctuation = 0.0;  ///< allowed: greatest minus least speed, over the mean speed
  SourceRange where;
};

/// A body that may carry a counterweight.
struct CounterweightPlan {
  BodyId body;
  SourceRange where;
};

/// A coupling that must not lose its force.
struct LimitedCoupling {
  CouplingId coupling;
  SourceRange where;
};

/// An actuator whose powers and energies are reported.
struct WatchedActuator {
  int actuator = 0;  ///< index into Topology::actuators
  SourceRange where;
};

struct DynamicsPlan {
  std::vector<WatchedActuator> actuators;
  std::optional<FlywheelPlan> flywheel;
  int harmonics = 0;  ///< the highest order; 0: none
  std::vector<CounterweightPlan> counterweights;
  std::vector<LimitedCoupling> limited;
  SourceRange where;
};

/// Binds the section `dynamics` of a description that was bound to this mechanism without an error.
/// Empty if there is no such section.
std::optional<DynamicsPlan> bind_dynamics(const MechanismDescription& description,
                                          const Mechanism& mechanism);

}  // namespace kinestat
