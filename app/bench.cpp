#include <algorithm>
#include <cstdint>

#include "command.hpp"
#include "options/sweep_options.hpp"
#include "run/benchmark.hpp"
#include "terminal/seconds.hpp"

namespace kinestat::app {

namespace {

constexpr double kSeconds = 2.0;

struct BenchOptions {
  FileOptions files;
  BenchmarkChoice choice;
};

}  // namespace

void add_bench(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat bench\n"
      "  kinestat bench mechanisms/transmissions/ravigneaux.yaml\n"
      "  kinestat bench --case M1 --format csv train.yaml > trade.csv\n");
  auto options = std::make_shared<BenchOptions>();
  options->choice.limits.seconds = kSeconds;
  add_files(command, options->files);
  add_curves(command, options->files.analyse.load);
  command.get_option("FILE")->required(false)->description(
      "mechanism files, one after the other; - is\n"
      "standard input; default: built-in networks that\n"
      "are hard to solve, near a dead point and a long\n"
      "train");
  add_format(command, options->files);
  add_strict(command, options->files);
  with_value(command,
             command.add_option("--case", options->choice.case_label, "one case; default: all"),
             "CASE");
  add_count(
      command,
      "--rounds",
      [options](std::uint64_t rounds) {
        options->choice.limits.rounds = static_cast<int>(std::min<std::uint64_t>(rounds, 1000000));
        options->choice.limits.seconds = 1e30;
      },
      "how often each method is timed; default 15, or\n"
      "what fits into two seconds per case and side");
  run_when_chosen(command, job, [options] {
    return benchmark_files(options->files.paths, options->choice, options->files.analyse, seconds);
  });
}

}  // namespace kinestat::app
