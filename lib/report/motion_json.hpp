// A finite motion as JSON.
#pragma once

#include "report/json_values.hpp"
#include "report/motion_table.hpp"

namespace kinestat {

/// The key "motion" of a report. Every row begins with the step and ends with the status.
Json motion_json(const MotionTable& motion);

}  // namespace kinestat
