// Times one step of a finite motion, position and velocity, in units of a sine with its cosine.

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "files/load_file.hpp"
#include "interleave.hpp"
#include "ratio_table.hpp"
#include "studies/motion/motion.hpp"

namespace kinestat::bench {

namespace {

// 10^6 steps a second of a four-bar and 2·10^5 of a six-bar, on a core on which the unit takes 20
// ns or more.
constexpr double kFourBarTarget = 50.0;
constexpr double kSixBarTarget = 250.0;

constexpr int kSteps = 360;   // a turn
constexpr int kUnits = 1000;  // sines and cosines in one run

struct Subject {
  MotionNetwork network;
  MotionTask task;
};

// A full turn of the first actuator, in steps of a degree.
Subject read(const std::string& path) {
  SourceFile source;
  Diagnostics found;
  const std::optional<Loaded> loaded =
      load(KINESTAT_MECHANISMS "/" + path, LoadOptions{}, source, found);
  if (!loaded) {
    throw std::runtime_error(path + " cannot be read");
  }
  const int freedom = loaded->mechanism.topology.actuators.at(0).freedom;
  const auto drawn = bind_drawn_couplings(loaded->description, loaded->mechanism);
  return {.network = make_motion_network(loaded->mechanism, drawn, std::vector<int>{freedom}),
          .task = {.drives = {{.freedom = freedom, .from = 0.0, .to = 2.0 * std::numbers::pi}},
                   .steps = kSteps}};
}

void follow(const Subject& subject) {
  const MotionSolution solution = solve_motion(subject.network, subject.task);
  if (solution.status != MotionStatus::completed) {
    throw std::runtime_error("the motion is not complete");
  }
  keep(solution);
}

void sines() {
  double sum = 0.0;
  for (int i = 0; i < kUnits; ++i) {
    keep(i);
    sum += std::sin(0.01 * i) + std::cos(0.01 * i);
  }
  keep(sum);
}

Job job_for(std::string name, const std::string& path, std::optional<double> target) {
  return {std::move(name),
          [subject = read(path)] { follow(subject); },
          target,
          static_cast<double>(kSteps) / kUnits};
}

std::string run(const Options& options) {
  const std::vector<Job> jobs = {
      job_for("four-bar, position and velocity", "planar/four_bar.yaml", kFourBarTarget),
      job_for("Watt six-bar", "planar/watt_six_bar.yaml", kSixBarTarget),
      job_for("Stephenson six-bar", "planar/stephenson_six_bar.yaml", kSixBarTarget),
      job_for("crank-shaper", "planar/quick_return.yaml", {}),
      job_for("Bennett linkage", "spatial/bennett.yaml", {}),
      job_for("Schatz linkage", "spatial/schatz_linkage.yaml", {}),
      job_for("two Hooke joints", "spatial/cardan_shaft.yaml", {}),
      job_for("open belt", "cables/open_belt.yaml", {})};
  const Interleaved result = measure(sines, jobs, options.rounds);
  std::string text = write_ratios(result.ratios, "sines", options.form);
  if (options.form == TableForm::text) {
    const double unit = result.unit_seconds / kUnits;
    text += fmt::format("a sine with its cosine takes {:.1f} ns here\n", 1e9 * unit);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      text += fmt::format("{}: {:.2f} million steps a second\n",
                          jobs[i].name,
                          1e-6 / (unit * result.ratios[i].median));
    }
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("motion_bench", argc, argv, kinestat::bench::run);
}
