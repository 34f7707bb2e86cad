#include "studies/sweep/report/sweep_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/text.hpp"

namespace kinestat {

namespace {

// As a word of a POSIX shell.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c == '\'' ? std::string_view("'\\''") : std::string_view(&c, 1);
  }
  return quoted + "'";
}

std::string share(double part, double whole) {
  return fmt::format("{:.3g} %", whole > 0.0 ? 100.0 * part / whole : 0.0);
}

std::string size_text(double bytes) {
  constexpr double kStep = 1000.0;
  std::size_t unit = 0;
  constexpr std::string_view kUnits[] = {"B", "kB", "MB", "GB", "TB"};
  while (bytes >= kStep && unit + 1 < std::size(kUnits)) {
    bytes /= kStep;
    ++unit;
  }
  return fmt::format("{:.2g} {}", bytes, kUnits[unit]);
}

// Tasks of ten minutes or so: short enough to find a place in a queue, long enough to be worth it.
std::string slurm_lines(const SweepForecast& forecast) {
  constexpr double kTask = 600.0;
  constexpr double kMinute = 60.0;
  constexpr double kMostTasks = 1000.0;
  constexpr double kMargin = 3.0;  // of other machines
  const auto chunks = static_cast<double>(forecast.metadata.chunks);
  const double tasks =
      std::min(std::clamp(std::ceil(forecast.whole_seconds() / kTask), 2.0, kMostTasks), chunks);
  const double seconds = forecast.whole_seconds() / tasks;
  std::string command = "kinestat sweep --jobs 1";
  for (const std::string& word : forecast.words) {
    command += " " + shell_word(word);
  }
  command += " --shard $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT --resume --quiet --out shards";
  return fmt::format(
      "Slurm, {} tasks of {}:\n"
      "  mkdir -p shards results\n"
      "  sbatch --array=1-{} --ntasks=1 --cpus-per-task=1 --time={} --requeue --wrap {}\n"
      "  kinestat merge --out results shards/{}.sweep-*.shard\n",
      tasks,
      duration_text(seconds),
      tasks,
      std::ceil(kMargin * seconds / kMinute),
      shell_word(command),
      shell_word(forecast.metadata.stem));
}

}  // namespace

std::string forecast_text(const SweepForecast& forecast) {
  const SweepMetadata& metadata = forecast.metadata;
  const SweepCounts& sampled = forecast.sampled;
  const auto states = static_cast<double>(sampled.states);
  const double whole = static_cast<double>(metadata.states) / states;
  std::string text =
      fmt::format("{}: {} states in {} chunks\n", metadata.stem, metadata.states, metadata.chunks);
  text += fmt::format("{} of them here and there, on one core: {:.3g} s, {:.3g} states/s\n",
                      sampled.states,
                      forecast.seconds,
                      forecast.states_per_second());
  text += fmt::format("  analysed: {}\n", share(static_cast<double>(sampled.analysed()), states));
  for (const auto& [status, count] : sampled.statuses) {
    text += fmt::format("  {}: {} of the rows\n",
                        status,
                        share(static_cast<double>(count), static_cast<double>(sampled.rows)));
  }
  text += fmt::format("The whole: about {} on one core", duration_text(forecast.whole_seconds()));
  if (forecast.jobs > 1) {
    text +=
        fmt::format(", {} with --jobs {}",
                    duration_text(forecast.whole_seconds() / static_cast<double>(forecast.jobs)),
                    forecast.jobs);
  }
  if (!metadata.best) {
    text += fmt::format("; {:.2g} rows, {}",
                        whole * static_cast<double>(sampled.kept()),
                        size_text(whole * static_cast<double>(forecast.bytes)));
  }
  return text + "\n" + slurm_lines(forecast);
}

}  // namespace kinestat
