// Every combination of the parameters that a file varies, row by row.
#pragma once

#include <optional>
#include <string>

#include "core/source.hpp"
#include "files/outcome.hpp"
#include "studies/sweep/report/sweep_table.hpp"
#include "studies/sweep/task/sweep_options.hpp"

namespace kinestat {

/// The rows of the section `sweep` of a description that was read from `source`, for pictures.
/// Empty iff an error was added.
std::optional<SweepTable> find_sweep_table(const SourceFile& source,
                                           const MechanismDescription& description,
                                           Diagnostics& found);

/// Runs the sweep of a file. With a folder, <name>.sweep.csv (or .jsonl, .npy) and
/// <name>.sweep.json are written whole at the end; of a shard, <name>.sweep-K-of-N.shard. What is
/// finished on the way waits in a folder <name>.sweep-work beside them, where --resume finds it.
/// The bytes of the result depend on the file, the overrides, the options of its form and the
/// version alone: not on the number of threads, shards or interruptions.
Outcome sweep_file(const std::string& path, const SweepOptions& options, const SweepHooks& hooks);

}  // namespace kinestat
