// Times the states of a sweep, from their number to the text of their rows, in units of a dense
// solve by LAPACK.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "dense_statics.hpp"
#include "interleave.hpp"
#include "ratio_table.hpp"
#include "run/internal/state_solver.hpp"
#include "run/internal/sweep_task.hpp"
#include "subject.hpp"

namespace kinestat::bench {

namespace {

constexpr double kEverything = 3.0;  // a third of the throughput of bare dense solves
constexpr double kShareOfRatio = 0.2;

Value value(const char* text) {
  return {.expression = std::get<Expression>(parse_expression(text)), .where = {}};
}

VariedParameter varied(const char* name, const char* from, const char* to) {
  VariedParameter result;
  result.name = {.text = name, .where = {}};
  result.from = value(from);
  result.to = value(to);
  result.step = value("1");
  return result;
}

// 20 · 20 · 20 states of case M1; without names of quantities all rates, actions and ratios.
SweepTask make_task(const Subject& subject, const std::vector<std::string>& report) {
  Loaded loaded = subject.loaded;
  SweepDescription sweep;
  sweep.vary = {varied("N1", "15", "34"), varied("N2", "31", "50"), varied("N5", "12", "31")};
  sweep.cases = {{.text = "M1", .where = {}}};
  for (const std::string& name : report) {
    sweep.report.push_back({.text = name, .where = {}});
  }
  loaded.description.sweep = std::move(sweep);
  Diagnostics found;
  std::optional<SweepTask> task =
      make_sweep_task(subject.source, std::move(loaded), SweepOptions{}, found);
  if (!task) {
    throw std::runtime_error("the sweep cannot be made");
  }
  return *std::move(task);
}

// One state after the other, and again from the first.
class RowMaker {
 public:
  RowMaker(const Subject& subject, const std::vector<std::string>& report, bool uses_tapes)
      : task_(make_task(subject, report)) {
    if (uses_tapes) {
      task_.tapes = record_tapes(task_);
      if (!task_.tapes) {
        throw std::runtime_error("the sweep has no tapes");
      }
    }
    solver_ = std::make_unique<StateSolver>(task_);
    text_ =
        std::make_unique<SweepRowText>(task_.plan, task_.cases, task_.quantities, RowFormat::csv);
  }

  void make_one() {
    if (!walk_ || !walk_->next()) {
      walk_.reset();
      walk_.emplace(task_.plan, 0, task_.plan.state_count());
      walk_->next();
    }
    rows_.clear();
    text_->enter(walk_->places());
    for (const SweepRow& row : solver_->solve(*walk_)) {
      text_->append(row, rows_);
    }
    keep(rows_);
  }

 private:
  SweepTask task_;
  std::unique_ptr<StateSolver> solver_;
  std::unique_ptr<SweepRowText> text_;
  std::optional<StateWalk> walk_;
  std::string rows_;
};

struct Options {
  int rounds = 300;
  TableForm form = TableForm::text;
};

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--csv") {
      options.form = TableForm::csv;
    } else if (word == "--rounds" && i + 1 < argc) {
      options.rounds = std::max(1, std::atoi(argv[++i]));
    } else {
      throw std::runtime_error("usage: sweep_bench [--rounds N] [--csv]");
    }
  }
  return options;
}

int run(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  const Subject subject = read_subject(KINESTAT_MECHANISM, "M1");
  const Mechanism& mechanism = subject.loaded.mechanism;
  DenseStatics dense(mechanism, subject.action, subject.which);
  if (!dense.is_square() || !dense.agrees(mechanism.topology, action_of(subject))) {
    throw std::runtime_error("solve_action and dgesv disagree");
  }
  RowMaker everything(subject, {}, true);
  RowMaker ratio(subject, {"ratio"}, true);
  RowMaker power(subject, {"ratio", "efficiency", "recirculation"}, false);
  RowMaker whole(subject, {}, false);
  const std::vector<Job> jobs = {
      {"a state, all rates, actions and ratios", [&] { everything.make_one(); }, kEverything},
      {"a state, the ratio alone", [&] { ratio.make_one(); }, {}},
      {"a state without tapes, as everything", [&] { whole.make_one(); }, {}},
      {"a state without tapes, with power flow", [&] { power.make_one(); }, {}},
  };
  const Interleaved result = measure([&] { dense.solve(); }, jobs, options.rounds);
  std::string text = write_ratios(result.ratios, "D", options.form);
  if (options.form == TableForm::text) {
    const double share = result.ratios[1].median / result.ratios[0].median;
    text += fmt::format("the ratio alone costs {:.3f} of everything (target {}: {})\n",
                        share,
                        kShareOfRatio,
                        share <= kShareOfRatio ? "held" : "missed");
    text += fmt::format(
        "D = dgesv of {0} x {0}, here {1:.1f} µs\n", dense.size(), 1e6 * result.unit_seconds);
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

}  // namespace

}  // namespace kinestat::bench

int main(int argc, char** argv) {
  try {
    return kinestat::bench::run(argc, argv);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "sweep_bench: %s\n", problem.what());
    return 1;
  }
}
