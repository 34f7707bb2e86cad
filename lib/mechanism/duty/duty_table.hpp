// Points of a duty from a table beside the mechanism file.
#pragma once

#include <string_view>

#include "mechanism/duty/duty_plan.hpp"

namespace kinestat {

/// Adds a point a line: columns `case`, `duration [s]` or `time [s]`, at which a line begins to
/// hold until the next one does, and `ACTUATOR [unit]`, a speed or a load of an input by its unit.
/// An empty cell leaves the magnitude that the case has. `name` is that of the table in messages.
void add_duty_table(const MechanismDescription& description,
                    const Mechanism& mechanism,
                    std::string_view name,
                    std::string_view text,
                    DutyPlan& plan,
                    Diagnostics& found);

}  // namespace kinestat
