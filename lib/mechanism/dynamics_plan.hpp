// The section `dynamics` bound to numbers.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

struct FlywheelPlan {
  int actuator = 0;          ///< index into Topology::actuators
  double fluctuation = 0.0;  ///< that is allowed: greatest less least speed, over the mean
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

/// An actuator whose powers and energies are told.
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

/// Of a description that has been bound to this mechanism without an error; empty if it has no
/// section `dynamics`.
std::optional<DynamicsPlan> bind_dynamics(const MechanismDescription& description,
                                          const Mechanism& mechanism);

}  // namespace kinestat
