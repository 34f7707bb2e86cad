#include "interleave.hpp"

#include <chrono>
#include <utility>

#include "studies/benchmark/interleaved_times.hpp"

namespace kinestat::bench {

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Interleaved measure(const std::function<void()>& unit, const std::vector<Job>& jobs, int rounds) {
  std::vector<std::function<void()>> runs;
  for (const Job& job : jobs) {
    runs.push_back(job.run);
  }
  InterleavedTimes times = time_interleaved(unit, runs, {.rounds = rounds}, seconds);
  Interleaved result;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    for (double& ratio : times.ratios[j]) {
      ratio /= jobs[j].parts;
    }
    result.ratios.push_back(make_ratio(jobs[j].name, std::move(times.ratios[j]), jobs[j].target));
  }
  result.unit_seconds = median_of(std::move(times.unit));
  return result;
}

}  // namespace kinestat::bench
