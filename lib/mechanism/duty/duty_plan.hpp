// The section `duty` bound to numbers: points of a duty cycle and the exponents of wear.
#pragma once

#include <optional>
#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/duty/duty_point.hpp"

namespace kinestat {

struct DutyPlan {
  std::vector<DutyPoint> points;
  double repetitions = 1.0;
  std::optional<double> gear_exponent;
  std::optional<double> bearing_exponent;
};

/// Binds the section. Empty iff an error was added.
std::optional<DutyPlan> bind_duty(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  Diagnostics& found);

}  // namespace kinestat
