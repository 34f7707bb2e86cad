// The section `dynamics`: what is asked of a motion with inertia beside its rows.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// A flywheel that keeps the speed of a cycle nearly steady.
struct FlywheelDescription {
  Name at;            ///< the actuator on whose freedom it turns
  Value fluctuation;  ///< greatest less least speed, over the mean
};

/// Counterweights against the shaking force.
struct BalanceDescription {
  std::vector<Name> bodies;  ///< that may carry one
};

struct DynamicsDescription {
  std::vector<Name> actuators;  ///< whose powers and energies are told
  std::optional<FlywheelDescription> flywheel;
  std::optional<Value> harmonics;  ///< the highest order by the turn of the drive
  std::optional<BalanceDescription> balance;
  std::vector<Name> limit_speed;  ///< contacts and cable segments that must not lose their force
  SourceRange where;
};

}  // namespace kinestat
