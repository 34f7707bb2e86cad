// The shards of one sweep, joined.
#pragma once

#include <string>
#include <vector>

#include "run/sweep.hpp"

namespace kinestat {

struct MergeOptions {
  std::string folder;  ///< for the result; empty: rows go to SweepHooks::write
  Overwrite overwrite = Overwrite::own_only;
  DiagnosticsForm diagnostics = DiagnosticsForm::text;
  bool is_quiet = false;  ///< no counts on standard error
};

/// Joins all shards of a sweep to the result that it would have given in one piece, byte for byte.
/// Nothing is written unless every shard is there once, whole and of the same plan: E0906 names
/// those that are damaged, cut off or of another sweep, E0907 those that are missing or there
/// twice.
Outcome merge_files(const std::vector<std::string>& paths,
                    const MergeOptions& options,
                    const SweepHooks& hooks);

}  // namespace kinestat
