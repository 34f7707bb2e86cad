// The section `duty` bound to numbers: points of a duty cycle and the exponents of wear.
#pragma once

#include <optional>
#include <string>
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

/// "point 3", counted from 1, or "in line 7" of a table.
std::string place_of(const DutyPlan& plan, std::size_t point);

/// Binds the section. Empty iff an error was added.
std::optional<DutyPlan> bind_duty(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  Diagnostics& found);

}  // namespace kinestat
