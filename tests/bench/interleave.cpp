#include "interleave.hpp"

#include <algorithm>
#include <chrono>

namespace kinestat::bench {

namespace {

constexpr double kBatchSeconds = 1.5e-4;

double seconds_of(const std::function<void()>& run, int count) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    run();
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / count;
}

// How many runs make a batch; the runs made to find out also warm the caches.
int batch_of(const std::function<void()>& run) {
  double fastest = seconds_of(run, 1);
  for (int i = 0; i < 20; ++i) {
    fastest = std::min(fastest, seconds_of(run, 1));
  }
  return std::max(1, static_cast<int>(kBatchSeconds / fastest));
}

}  // namespace

Interleaved measure(const std::function<void()>& unit, const std::vector<Job>& jobs, int rounds) {
  const int unit_batch = batch_of(unit);
  std::vector<int> batches;
  for (const Job& job : jobs) {
    batches.push_back(batch_of(job.run));
  }
  std::vector<std::vector<double>> ratios(jobs.size());
  std::vector<double> unit_times;
  for (int round = 0; round < rounds; ++round) {
    double before = seconds_of(unit, unit_batch);
    for (std::size_t j = 0; j < jobs.size(); ++j) {
      const double time = seconds_of(jobs[j].run, batches[j]);
      const double after = seconds_of(unit, unit_batch);
      ratios[j].push_back(2.0 * time / (before + after) / jobs[j].parts);
      unit_times.push_back(after);
      before = after;
    }
  }
  Interleaved result;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    result.ratios.push_back(make_ratio(jobs[j].name, std::move(ratios[j]), jobs[j].target));
  }
  result.unit_seconds = make_ratio({}, std::move(unit_times), {}).median;
  return result;
}

}  // namespace kinestat::bench
