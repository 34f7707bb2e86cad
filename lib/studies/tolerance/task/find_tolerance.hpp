// What tolerances do to the positions of a file.
#pragma once

#include <optional>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "studies/tolerance/report/tolerance_report.hpp"
#include "studies/tolerance/task/tolerance_choice.hpp"

namespace kinestat {

/// In the drawn position with the drives of each case held, or along the motion of the file with
/// its drives held. Empty iff an error was added and there is nothing to report: a motion that ends
/// early has steps.
std::optional<FoundTolerance> find_tolerance(const Analysis& analysis,
                                             const ToleranceChoice& choice,
                                             Diagnostics& found);

}  // namespace kinestat
