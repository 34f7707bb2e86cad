// The characteristic of a torque converter as the user wrote it.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// Each quantity is a list, as long as that of the speed ratios, or one expression of
/// `speed_ratio`.
struct CharacteristicDescription {
  std::vector<Value> speed_ratio;   ///< of turbine to pump, rising; empty without lists
  std::vector<Value> torque_ratio;  ///< of turbine to pump; empty of a fluid coupling
  std::vector<Value> pump_torque;   ///< at `pump_speed`
  std::optional<Value> pump_speed;
  std::vector<Value> lambda;  ///< or: torque over density · diameter^5 · pump speed^2
  std::optional<Value> density;
  std::optional<Value> diameter;
  SourceRange where;
};

}  // namespace kinestat
