// Jobs timed in turn, so that whatever slows the machine slows all of them.
#pragma once

#include <functional>
#include <vector>

namespace kinestat {

/// Seconds of a clock that nobody sets back.
using Clock = std::function<double()>;

/// How long to measure.
struct TimingLimits {
  int rounds = 15;        ///< of all jobs
  double seconds = 1e30;  ///< begins no further round after that
};

struct InterleavedTimes {
  std::vector<std::vector<double>> ratios;  ///< of each job to the unit, one a round
  std::vector<double> unit;                 ///< times of the unit [s]
};

/// In every round each job runs for a batch, long enough for the clock and short enough to be
/// seldom interrupted, and is divided by batches of the unit right before and after it.
InterleavedTimes time_interleaved(const std::function<void()>& unit,
                                  const std::vector<std::function<void()>>& jobs,
                                  const TimingLimits& limits,
                                  const Clock& clock);

/// The value in the middle; of an even number the mean of the two. `values` must not be empty.
double median_of(std::vector<double> values);

}  // namespace kinestat
