// The best linkages over what a synthesis task leaves free.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "studies/synthesis/task/synthesis_task.hpp"

namespace kinestat {

/// The tasks of some choice of what varies, one for every choice of angles that are lists. Empty
/// iff an error was added: all choices that are tried contradict themselves, or the task has
/// another number of positions than what varies is for.
std::optional<std::vector<std::vector<PositionJets>>> find_selection_tasks(
    const SynthesisValues& values, const SynthesisDescription& task, Diagnostics& found);

/// Adds the best choices as tasks of the analysis, with the counts of the selection; for every
/// choice of angles that are lists. On up to `jobs` threads, 0 for as many as the machine has
/// cores; the result does not depend on them. False iff an error was added.
bool select_tasks(const SynthesisValues& values,
                  std::uint64_t jobs,
                  Diagnostics& found,
                  SynthesisAnalysis& analysis);

}  // namespace kinestat
