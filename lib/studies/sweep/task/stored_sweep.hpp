// A sweep whose chunks are kept as files until its result is made of them.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/work_folder.hpp"
#include "studies/sweep/task/chunk_runner.hpp"
#include "studies/sweep/task/sweep_result.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

/// Finished chunks wait in a work folder beside the result, so that an interrupted run can go on.
class StoredSweep {
 public:
  /// The result takes the place of none of the inputs.
  StoredSweep(const SweepTask& task,
              const SweepOptions& options,
              std::vector<std::string> inputs,
              const SweepHooks& hooks,
              Diagnostics& found)
      : task_(task),
        options_(options),
        inputs_(std::move(inputs)),
        hooks_(hooks),
        found_(found),
        shard_(options.shard.value_or(ShardNumber{})),
        chunks_(task.plan.chunk_count()) {}

  /// Opens the work folder and finds what an earlier run has finished; false iff an error was
  /// added.
  bool prepare();

  /// Whether `prepare` has found the result of the same plan, so that nothing is left to do.
  bool was_finished() const { return was_finished_; }

  /// Works off the chunks that are missing.
  RunEnd run(std::uint64_t jobs);

  /// Makes the result out of the chunks and removes these; false iff an error was added.
  bool finish();

  const SweepCounts& counts() const { return counts_; }

 private:
  bool is_whole_sweep() const { return !options_.shard; }

  std::string shard_name() const;
  std::string work_name() const;
  std::uint64_t states_before(std::uint64_t chunk) const;

  std::vector<OutputFile> outputs(const std::vector<PieceFile>& files,
                                  const std::string& scratch) const;

  NextPiece shard_pieces(const std::vector<PieceFile>& files) const;

  bool is_finished() const;
  std::string summary_text() const;
  bool take_stock();
  bool take_stock_of(const std::string& name);

  bool store(ChunkResult result);

  const SweepTask& task_;
  const SweepOptions& options_;
  std::vector<std::string> inputs_;
  const SweepHooks& hooks_;
  Diagnostics& found_;
  ShardNumber shard_;
  std::uint64_t chunks_ = 0;
  std::optional<WorkFolder> work_;
  std::vector<std::uint64_t> done_;
  bool was_finished_ = false;
  SweepCounts counts_;
  std::mutex mutex_;
};

}  // namespace kinestat
