// How a sweep is run, and how far it is.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/load_file.hpp"
#include "files/outcome.hpp"
#include "io/atomic_file.hpp"
#include "studies/sweep/report/sweep_metadata.hpp"

namespace kinestat {

/// How far a sweep is. States that were finished before it began count as `resumed`.
struct SweepProgress {
  std::uint64_t states = 0;  ///< done, those left out included
  std::uint64_t resumed = 0;
  std::uint64_t total = 0;
  std::uint64_t rows = 0;  ///< since it began
};

/// What connects a sweep with the process it runs in.
struct SweepHooks {
  /// Takes rows for standard output; false if they cannot be written.
  std::function<bool(std::string_view)> write;
  /// Is told now and then how far it is, by one thread at a time; may be empty.
  std::function<void(const SweepProgress&)> progress;
  /// Once it is true, the sweep ends after the chunks that are written; may be null.
  const std::atomic<bool>* stop = nullptr;
};

/// What it takes to tell how long a sweep would run.
struct ForecastRequest {
  std::vector<std::string> words;  ///< of its command line that every share of it has
  std::function<double()> clock;   ///< seconds of the processor since some moment
};

struct SweepOptions {
  LoadOptions load;
  RowFormat format = RowFormat::csv;
  std::string folder;  ///< for the result; empty: rows go to SweepHooks::write
  Overwrite overwrite = Overwrite::own_only;
  std::uint64_t jobs = 0;            ///< threads; 0: as many as the machine has cores
  std::optional<ShardNumber> shard;  ///< only this share; needs a folder
  bool resume = false;               ///< go on with what an interrupted run has finished
  std::optional<BestChoice> best;    ///< keep these rows alone
  DiagnosticsForm diagnostics = DiagnosticsForm::text;
  std::optional<ForecastRequest> forecast;  ///< tell what it would take instead of running it
  bool is_quiet = false;                    ///< no counts on standard error
};

}  // namespace kinestat
