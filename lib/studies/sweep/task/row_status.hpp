// The status of a row of a sweep: "solved", "locked", "no_ratio", …
#pragma once

#include <string_view>

#include "cases/analysis.hpp"
#include "studies/sweep/report/sweep_status.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

/// What the status of a row says of a case of the mechanism of a state: that of its motion, of its
/// actions where they are asked for, or why it has no ratio. What is known suffices and is
/// independent with the parameters of the file if `is_usually_solved`: then a state in which it is
/// not stands in a singular position.
std::string_view row_status(const CaseAnalysis& one,
                            const SweepTask& task,
                            const Mechanism& mechanism,
                            bool is_usually_solved);

/// Why a solved case has no ratio: "locked" where the input rests (0/0 too), "no_ratio" where the
/// output does.
std::string_view status_without_ratio(bool is_input_at_rest);

}  // namespace kinestat
