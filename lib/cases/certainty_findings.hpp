// What is to be said of the certainty of answers.
#pragma once

#include "cases/analysis.hpp"
#include "cases/certainty.hpp"
#include "core/diagnostic.hpp"

namespace kinestat {

/// Both ranks where rounding to double decides, W0501.
void add_rank_findings(const Certainty& certainty, Diagnostics& found);

/// Both answers where rounding to double decides, W0501; fewer digits than asked for, W0502.
void add_certainty_findings(const Analysis& analysis,
                            const Certainty& certainty,
                            Diagnostics& found);

}  // namespace kinestat
