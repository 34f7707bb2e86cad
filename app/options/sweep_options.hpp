// The options that `sweep` and `merge` share, and what connects them with the process.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "options/file_options.hpp"
#include "run/sweep.hpp"
#include "terminal/progress_line.hpp"

namespace kinestat::app {

/// Declares an option that takes a whole number, the least or more.
void add_count(CLI::App& command,
               const std::string& name,
               std::function<void(std::uint64_t)> take,
               const std::string& description,
               std::uint64_t least = 1);

/// Declares -o/--out with this description, and --force.
void add_result_folder(CLI::App& command,
                       std::string& folder,
                       Overwrite& overwrite,
                       const std::string& description);

/// "2/7"; anything else throws.
ShardNumber read_shard(const std::string& word);

/// Declares --progress.
void add_progress(CLI::App& command, ProgressChoice& choice);

/// Declares --diagnostics and --quiet.
void add_messages(CLI::App& command, DiagnosticsForm& form, bool& is_quiet);

/// Runs a job that streams rows. Ends the process by the signal that has interrupted it, after what
/// it had to say.
Outcome run_streaming(const std::function<Outcome(const SweepHooks&)>& job,
                      const std::function<void(const SweepProgress&)>& progress);

}  // namespace kinestat::app
