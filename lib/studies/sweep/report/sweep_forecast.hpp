// What a sweep will take, before it is run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "studies/sweep/report/sweep_metadata.hpp"

namespace kinestat {

/// Some states of a sweep that were worked off on one core, and what is asked of the whole.
struct SweepForecast {
  const SweepMetadata& metadata;
  SweepCounts sampled;
  double seconds = 0.0;     ///< that they took
  std::uint64_t bytes = 0;  ///< of their rows
  std::uint64_t jobs = 1;   ///< threads of a run on one machine
  /// The command line without what a share of the sweep has of its own: jobs, shard, folder.
  std::vector<std::string> words;

  double states_per_second() const { return static_cast<double>(sampled.states) / seconds; }

  /// Of the whole on one core.
  double whole_seconds() const {
    return static_cast<double>(metadata.states) / states_per_second();
  }
};

/// States, time and size of the whole, and the lines for Slurm, each a command to be pasted.
std::string forecast_text(const SweepForecast& forecast);

}  // namespace kinestat
