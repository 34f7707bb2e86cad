// The columns that the report of a motion names one by one.
#pragma once

#include <functional>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "mechanism/motion_plan.hpp"
#include "studies/motion/task/columns/motion_columns.hpp"

namespace kinestat {

/// Finds what `MotionReport::columns` of the plan name, and makes its report one that has them and,
/// beside these, no more than it had. A name is that of a column, of a part with all its columns,
/// or of what several begin with; points and slashes are alike. False iff an error was added: there
/// is no such column, E0313, or the case does not say what it needs, E0303.
bool choose_columns(const MechanismDescription& description,
                    const Mechanism& mechanism,
                    MotionPlan& plan,
                    Diagnostics& found);

/// Erases all that is not wanted.
void keep_readings(const std::function<bool(const MotionColumn&)>& is_wanted,
                   std::vector<MotionReading>& readings);

}  // namespace kinestat
