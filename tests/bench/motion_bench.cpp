// Times one step of a finite motion, position and velocity, and one state of a sweep of motions, in
// units of a sine with its cosine.

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_program.hpp"
#include "files/load_file.hpp"
#include "interleave.hpp"
#include "ratio_table.hpp"
#include "studies/motion/motion.hpp"
#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat::bench {

namespace {

// 10^6 steps a second of a four-bar and 2·10^5 of a six-bar, on a core on which the unit takes 20
// ns or more.
constexpr double kFourBarTarget = 50.0;
constexpr double kSixBarTarget = 250.0;

// 20 µs a state there, of 72 positions: a stroke and the least transmission angle.
constexpr double kStateTarget = 1000.0;

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

// The states of a sweep of crank-rockers, some here and some there, so that all kinds are among
// them.
class StateMaker {
 public:
  explicit StateMaker(std::size_t lanes) {
    SourceFile source;
    Diagnostics found;
    std::optional<Loaded> loaded =
        load(KINESTAT_MECHANISMS "/sweeps/crank_rocker_search.yaml", LoadOptions{}, source, found);
    if (loaded) {
      task_ = make_sweep_task(source, *std::move(loaded), SweepOptions{}, found);
    }
    if (!task_) {
      throw std::runtime_error("the sweep cannot be made");
    }
    solver_ = std::make_unique<StateSolver>(*task_, lanes);
  }

  void make(std::size_t count) {
    for (std::size_t made = 0; made < count;) {
      std::span<const SolvedState> states;
      if (walk_) {
        states = solver_->solve_next(*walk_);
      }
      if (states.empty()) {
        constexpr std::uint64_t kTogether = 40;
        constexpr std::uint64_t kStride = 611953;  // a prime
        const std::uint64_t all = task_->plan.state_count();
        begin_ = (begin_ + kStride) % (all - kTogether);
        walk_.emplace(task_->plan, begin_, begin_ + kTogether);
        continue;
      }
      made += states.size();
      keep(states);
    }
  }

 private:
  std::optional<SweepTask> task_;
  std::unique_ptr<StateSolver> solver_;
  std::optional<StateWalk> walk_;
  std::uint64_t begin_ = 0;
};

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

Job state_job(std::string name,
              const std::shared_ptr<StateMaker>& states,
              std::size_t count,
              std::optional<double> target) {
  return {std::move(name),
          [states, count] { states->make(count); },
          target,
          static_cast<double>(count) / kUnits};
}

std::string run(const Options& options) {
  const auto lanes = std::make_shared<StateMaker>(kLanes);
  const auto whole = std::make_shared<StateMaker>(1);
  const std::vector<Job> jobs = {
      job_for("four-bar, position and velocity", "planar/four_bar.yaml", kFourBarTarget),
      job_for("Watt six-bar", "planar/watt_six_bar.yaml", kSixBarTarget),
      job_for("Stephenson six-bar", "planar/stephenson_six_bar.yaml", kSixBarTarget),
      job_for("crank-shaper", "planar/quick_return.yaml", {}),
      job_for("Bennett linkage", "spatial/bennett.yaml", {}),
      job_for("Schatz linkage", "spatial/schatz_linkage.yaml", {}),
      job_for("two Hooke joints", "spatial/cardan_shaft.yaml", {}),
      job_for("open belt", "cables/open_belt.yaml", {}),
      state_job("a crank-rocker of a sweep, 72 positions", lanes, 200, kStateTarget),
      state_job("  as a whole motion", whole, 4, {})};
  const Interleaved result = measure(sines, jobs, options.rounds);
  std::string text = write_ratios(result.ratios, "sines", options.form);
  if (options.form == TableForm::text) {
    const double unit = result.unit_seconds / kUnits;
    text += fmt::format("a sine with its cosine takes {:.1f} ns here\n", 1e9 * unit);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      text += fmt::format(
          "{}: {:.4g} million a second\n", jobs[i].name, 1e-6 / (unit * result.ratios[i].median));
    }
  }
  return text;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  return kinestat::bench::run_program("motion_bench", argc, argv, kinestat::bench::run);
}
