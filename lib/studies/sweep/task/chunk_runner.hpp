// The chunks of a sweep, worked off by threads.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "studies/sweep/sweep_counts.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

/// The rows of a chunk: as they stand in the result, or as write_rows has them where only the top
/// rows are kept.
struct ChunkResult {
  std::uint64_t chunk = 0;
  std::string body;
  SweepCounts counts;
};

/// What some states of a sweep gave and took on one core.
struct StateSample {
  SweepCounts counts;
  std::uint64_t bytes = 0;  ///< of rows
  double seconds = 0.0;     ///< of the processor
};

/// Works off states here and there, evenly spread over the chunks, for about that long or until
/// every chunk was visited. The clock tells the seconds of the processor since some moment.
StateSample sample_states(const SweepTask& task,
                          double seconds,
                          const std::function<double()>& clock);

/// Where finished chunks go. `take` answers false if it cannot take more: the run ends.
struct ChunkSink {
  enum class Order {
    any,       ///< as they are finished, by several threads at once
    ascending  ///< by their numbers, by one thread at a time
  };

  Order order = Order::any;
  std::function<bool(ChunkResult)> take;
};

enum class RunEnd { complete, stopped, refused };

/// Works off the chunks, which must be ascending, on up to that many threads. Few results wait for
/// their turn at any time, so that the memory depends on the number of threads alone. `progress`
/// holds what was finished before. A chunk during which the run is stopped is not delivered.
RunEnd run_chunks(const SweepTask& task,
                  const std::vector<std::uint64_t>& chunks,
                  std::uint64_t jobs,
                  const ChunkSink& sink,
                  const SweepHooks& hooks,
                  SweepProgress progress);

}  // namespace kinestat
