// Findings about the certainty of answers.
#pragma once

#include "cases/analysis.hpp"
#include "cases/certainty.hpp"
#include "core/diagnostic.hpp"

namespace kinestat {

/// Adds W0501, with both ranks, for each rank that depends on the rounding of numbers to double.
void add_rank_findings(const Certainty& certainty, Diagnostics& found);

/// Adds W0501 for each answer that depends on the rounding of numbers to double, and W0502 for each
/// answer with fewer digits than requested.
void add_certainty_findings(const Analysis& analysis,
                            const Certainty& certainty,
                            Diagnostics& found);

}  // namespace kinestat
