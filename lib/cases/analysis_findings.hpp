// Statuses of the passes as diagnostics at the lines of their cases.
#pragma once

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"

namespace kinestat {

/// Says for every case that was not solved why, and what to give instead.
void add_findings(const Analysis& analysis, Diagnostics& found);

}  // namespace kinestat
