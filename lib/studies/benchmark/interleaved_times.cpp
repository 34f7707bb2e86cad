#include "studies/benchmark/interleaved_times.hpp"

#include <algorithm>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr double kBatchSeconds = 0.00015;
constexpr double kProbeSeconds = 0.005;
constexpr int kProbes = 20;

double seconds_of(const std::function<void()>& run, int count, const Clock& clock) {
  const double start = clock();
  for (int i = 0; i < count; ++i) {
    run();
  }
  return (clock() - start) / count;
}

// How many runs make a batch; the runs made to find out also warm the caches.
int batch_of(const std::function<void()>& run, const Clock& clock) {
  const double start = clock();
  double fastest = seconds_of(run, 1, clock);
  for (int i = 0; i < kProbes && clock() - start < kProbeSeconds; ++i) {
    fastest = std::min(fastest, seconds_of(run, 1, clock));
  }
  return fastest < kBatchSeconds && fastest > 0.0 ? static_cast<int>(kBatchSeconds / fastest) : 1;
}

}  // namespace

InterleavedTimes time_interleaved(const std::function<void()>& unit,
                                  const std::vector<std::function<void()>>& jobs,
                                  const TimingLimits& limits,
                                  const Clock& clock) {
  const double start = clock();
  const int unit_batch = batch_of(unit, clock);
  std::vector<int> batches;
  for (const std::function<void()>& job : jobs) {
    batches.push_back(batch_of(job, clock));
  }
  InterleavedTimes result;
  result.ratios.resize(jobs.size());
  for (int round = 0; round < limits.rounds; ++round) {
    if (round > 0 && clock() - start > limits.seconds) {
      break;
    }
    double before = seconds_of(unit, unit_batch, clock);
    for (std::size_t j = 0; j < jobs.size(); ++j) {
      const double time = seconds_of(jobs[j], batches[j], clock);
      const double after = seconds_of(unit, unit_batch, clock);
      result.ratios[j].push_back(2.0 * time / (before + after));
      result.unit.push_back(after);
      before = after;
    }
  }
  return result;
}

double median_of(std::vector<double> values) {
  KINESTAT_EXPECTS(!values.empty());
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace kinestat
