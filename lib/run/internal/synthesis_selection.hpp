// The best linkages over what a synthesis task leaves free.
#pragma once

#include <cstdint>

#include "run/internal/synthesis_task.hpp"

namespace kinestat {

/// Adds the best choices as tasks of the analysis, with the counts of the selection; for every
/// choice of angles that are lists. On up to `jobs` threads, 0 for as many as the machine has
/// cores; the result does not depend on them. False iff an error was added.
bool select_tasks(const SynthesisValues& values,
                  std::uint64_t jobs,
                  Diagnostics& found,
                  SynthesisAnalysis& analysis);

}  // namespace kinestat
