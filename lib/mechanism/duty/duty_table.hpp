// Points of a duty from a table beside the mechanism file.
#pragma once

#include <string_view>

#include "mechanism/duty/duty_plan.hpp"

namespace kinestat {

/// Adds one point for each line of a table. Its columns are `case`; `duration [s]`, or `time [s]`
/// at which the line begins to hold until the next one does; and `ACTUATOR [unit]`, whose unit
/// decides whether it is a speed or a load. An empty cell keeps the magnitude of the case. `name`
/// is the name of the table in messages.
void add_duty_table(const MechanismDescription& description,
                    const Mechanism& mechanism,
                    std::string_view name,
                    std::string_view text,
                    DutyPlan& plan,
                    Diagnostics& found);

}  // namespace kinestat
