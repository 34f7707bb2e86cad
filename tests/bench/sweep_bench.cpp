// Times the states of a sweep, from their number to the text or the bytes of their rows, in units
// of a dense solve by LAPACK.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "dense_statics.hpp"
#include "format/mechanism_reader.hpp"
#include "interleave.hpp"
#include "io/read_file.hpp"
#include "ratio_table.hpp"
#include "studies/sweep/report/sweep_row_writer.hpp"
#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/sweep_task.hpp"
#include "subject.hpp"

namespace kinestat::bench {

namespace {

constexpr double kAlone = 0.05;
constexpr double kInLanes = 0.02;
constexpr double kTimesCheaper = 3.0;  // two outputs than all
constexpr double kWithLosses = 0.05;
constexpr double kAllGears = 1.0;
constexpr double kTimesForText = 15.0;  // numbers with their text, as against without
constexpr double kTimesForArray = 2.0;
constexpr std::size_t kStates = 400;  // timed together

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

// 20 · 20 · 20 states of case M1, none of them singular; without names of quantities all rates,
// actions and ratios.
SweepTask make_task(const Subject& subject, const std::vector<std::string>& report) {
  Loaded loaded = subject.loaded;
  SweepDescription sweep;
  sweep.vary = {varied("N1", "15", "34"), varied("N2", "64", "83"), varied("N5", "12", "31")};
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

// All gears of the 8HP70, of which the planets of one set and the sun of another vary and the rings
// with them: their efficiencies and the torques of the shift elements.
SweepTask make_gear_task() {
  Diagnostics found;
  const std::optional<SourceFile> original = read_file(KINESTAT_GEARBOX, {}, found);
  if (!original) {
    throw std::runtime_error("the gearbox cannot be read");
  }
  std::string text = original->text.substr(0, original->text.find("\npublished:"));
  const auto replace = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) {
      throw std::runtime_error("the gearbox has no '" + from + "'");
    }
    text.replace(at, from.size(), to);
  };
  replace("  torque: 100 N*m", "  torque: 100 N*m\n  p3: 21\n  s4: 23");
  replace("planet3, teeth: 21", "planet3, teeth: p3");
  replace("teeth: 111", "teeth: 69 + 2*p3");
  replace("sun4, teeth: 23", "sun4, teeth: s4");
  replace("teeth: 85", "teeth: s4 + 62");
  text += R"(
sweep:
  vary: {p3: {from: 20, to: 59, step: 1}, s4: {from: 20, to: 59, step: 1}}
  report: [efficiency, A, B, C, D, E]
)";
  const SourceFile source{.path = original->path, .text = text};
  const auto tree = read_yaml(source, {}, found);
  auto description = tree ? read_mechanism(*tree, found) : std::nullopt;
  std::optional<Loaded> loaded =
      description ? bind_loaded(*std::move(description), found) : std::nullopt;
  std::optional<SweepTask> task =
      loaded ? make_sweep_task(source, *std::move(loaded), SweepOptions{}, found) : std::nullopt;
  if (!task) {
    throw std::runtime_error("the sweep of all gears cannot be made");
  }
  return *std::move(task);
}

enum class Way { whole, tape_alone, tape_in_lanes };

enum class Form { numbers, text, array };

// The states of a sweep, group by group, and again from the first.
class RowMaker {
 public:
  RowMaker(const Subject& subject, const std::vector<std::string>& report, Way way, Form form)
      : RowMaker(make_task(subject, report), way, form) {}

  RowMaker(SweepTask task, Way way, Form form)
      : form_(form), lanes_(way == Way::tape_in_lanes ? kLanes : 1), task_(std::move(task)) {
    if (way != Way::whole) {
      task_.tapes = record_tapes(task_);
      if (!task_.tapes) {
        throw std::runtime_error("the sweep has no tapes");
      }
    }
    solver_ = std::make_unique<StateSolver>(task_, lanes_);
    writer_ =
        std::make_unique<SweepRowWriter>(task_.plan,
                                         task_.cases,
                                         task_.columns,
                                         form == Form::array ? RowFormat::npy : RowFormat::csv);
  }

  // States that follow one another, as they do in a sweep.
  void make_many() {
    for (std::size_t made = 0; made < kStates; made += lanes_) {
      make_some();
    }
  }

  // One state, or kLanes of them.
  void make_some() {
    std::span<const SolvedState> states = next();
    if (form_ != Form::numbers) {
      rows_.clear();
      for (const SolvedState& state : states) {
        writer_->enter(state.places);
        for (const SweepRow& row : state.rows) {
          writer_->append(row, rows_);
        }
      }
    }
    keep(states);
    keep(rows_);
  }

  std::size_t quantity_count() const { return task_.columns.size(); }

  const LaneTape& tape() const { return task_.tapes->tape; }

 private:
  std::span<const SolvedState> next() {
    std::span<const SolvedState> states;
    if (walk_) {
      states = solver_->solve_next(*walk_);
    }
    if (states.empty()) {
      walk_.reset();
      walk_.emplace(task_.plan, 1, task_.plan.state_count());  // 0 is analysed both ways
      states = solver_->solve_next(*walk_);
    }
    return states;
  }

  Form form_;
  std::size_t lanes_;
  SweepTask task_;
  std::unique_ptr<StateSolver> solver_;
  std::unique_ptr<SweepRowWriter> writer_;
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

// Of which the absolute model counts, so that a row needs both: only a train that does not lock has
// an efficiency.
Subject subject_with_losses() {
  Subject subject = read_subject(KINESTAT_LOSSY_MECHANISM, "M1");
  subject.loaded.description.losses->model = LossModel::absolute;
  subject.loaded.mechanism.loss_model = LossModel::absolute;
  return subject;
}

// What the actions are called that are not known, one for each column of the dense matrix.
std::vector<std::string> action_names(const Subject& subject) {
  const Topology& topology = subject.loaded.mechanism.topology;
  std::vector<std::string> names;
  for (int a = 0; a < topology.action_count(); ++a) {
    if (std::ranges::find(subject.which.actions, a, &Primary::index) ==
        subject.which.actions.end()) {
      names.push_back(topology.action_name(a));
    }
  }
  return names;
}

// The arithmetic alone, of the same kLanes states again and again.
class TapePlayer {
 public:
  explicit TapePlayer(const RowMaker& rows)
      : tape_(rows.tape()), workspace_(tape_.make_workspace(kLanes)) {
    const std::vector<double> teeth = {17.0, 70.0, 15.0};
    for (std::size_t i = 0; i < tape_.input_count(); ++i) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        tape_.set_input(workspace_, i, lane, teeth.at(i) + static_cast<double>(lane));
      }
    }
  }

  void play() {
    for (std::size_t played = 0; played < kStates; played += kLanes) {
      tape_.play(workspace_);
      keep(workspace_);
    }
  }

 private:
  const LaneTape& tape_;
  LaneTape::Workspace workspace_;
};

std::string cheaper_text(const char* how, const Ratio& two, const Ratio& all) {
  const double times = all.median / two.median;
  return fmt::format("two actions, {}: {:.1f} times cheaper than all (target {}: {})\n",
                     how,
                     times,
                     kTimesCheaper,
                     times >= kTimesCheaper ? "held" : "missed");
}

std::string rows_text(const char* rows_in_form,
                      const Ratio& rows,
                      const Ratio& numbers,
                      double target) {
  const double times = rows.median / numbers.median;
  return fmt::format("{}: {:.1f} times the numbers (target {}: {})\n",
                     rows_in_form,
                     times,
                     target,
                     times <= target ? "held" : "missed");
}

int run(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  const Subject subject = read_subject(KINESTAT_MECHANISM, "M1");
  const Mechanism& mechanism = subject.loaded.mechanism;
  DenseStatics dense(mechanism, subject.action, subject.which);
  if (!dense.is_square() || !dense.agrees(mechanism.topology, action_of(subject))) {
    throw std::runtime_error("solve_action and dgesv disagree");
  }
  const std::vector<std::string> actions = action_names(subject);
  const std::vector<std::string> two = {"out", "B2"};
  RowMaker alone(subject, actions, Way::tape_alone, Form::numbers);
  RowMaker lanes(subject, actions, Way::tape_in_lanes, Form::numbers);
  RowMaker two_alone(subject, two, Way::tape_alone, Form::numbers);
  RowMaker two_lanes(subject, two, Way::tape_in_lanes, Form::numbers);
  RowMaker numbers(subject, {}, Way::tape_in_lanes, Form::numbers);
  RowMaker text(subject, {}, Way::tape_in_lanes, Form::text);
  RowMaker array(subject, {}, Way::tape_in_lanes, Form::array);
  RowMaker ratio(subject, {"ratio"}, Way::tape_in_lanes, Form::numbers);
  RowMaker ratio_text(subject, {"ratio"}, Way::tape_in_lanes, Form::text);
  RowMaker ratio_array(subject, {"ratio"}, Way::tape_in_lanes, Form::array);
  RowMaker whole(subject, {}, Way::whole, Form::text);
  const Subject lossy = subject_with_losses();
  const std::vector<std::string> powers = {"ratio", "efficiency", "recirculation"};
  RowMaker power(lossy, powers, Way::tape_in_lanes, Form::numbers);
  RowMaker gears(make_gear_task(), Way::tape_in_lanes, Form::numbers);
  RowMaker whole_power(lossy, powers, Way::whole, Form::text);
  TapePlayer play_all(lanes);
  TapePlayer play_two(two_lanes);
  const auto all = fmt::format("all {} actions", actions.size());
  const auto everything = fmt::format("all {} rates, actions, ratios", numbers.quantity_count());
  const std::vector<Job> jobs = {
      {all + ", one state", [&] { alone.make_many(); }, kAlone, kStates},
      {all + ", in lanes", [&] { lanes.make_many(); }, kInLanes, kStates},
      {"  the arithmetic alone", [&] { play_all.play(); }, {}, kStates},
      {"two actions, one state", [&] { two_alone.make_many(); }, {}, kStates},
      {"two actions, in lanes", [&] { two_lanes.make_many(); }, {}, kStates},
      {"  the arithmetic alone", [&] { play_two.play(); }, {}, kStates},
      {everything + ", in lanes", [&] { numbers.make_many(); }, {}, kStates},
      {"  with their text", [&] { text.make_many(); }, {}, kStates},
      {"  as rows of an array", [&] { array.make_many(); }, {}, kStates},
      {"the ratio alone, in lanes", [&] { ratio.make_many(); }, {}, kStates},
      {"  with its text", [&] { ratio_text.make_many(); }, {}, kStates},
      {"  as rows of an array", [&] { ratio_array.make_many(); }, {}, kStates},
      {"losses by both models, power flow", [&] { power.make_many(); }, kWithLosses, kStates},
      {"all gears of the 8HP70 with losses", [&] { gears.make_many(); }, kAllGears, kStates},
      {"without tapes, all with their text", [&] { whole.make_some(); }, {}},
      {"without tapes, losses by both models", [&] { whole_power.make_some(); }, {}},
  };
  const Interleaved result = measure([&] { dense.solve(); }, jobs, options.rounds);
  std::string report = write_ratios(result.ratios, "D", options.form);
  if (options.form == TableForm::text) {
    report += cheaper_text("one state", result.ratios[3], result.ratios[0]);
    report += cheaper_text("in lanes", result.ratios[4], result.ratios[1]);
    report += cheaper_text("the arithmetic", result.ratios[5], result.ratios[2]);
    const std::vector<Ratio>& ratios = result.ratios;
    report += rows_text("all with their text", ratios[7], ratios[6], kTimesForText);
    report += rows_text("all as an array", ratios[8], ratios[6], kTimesForArray);
    report += rows_text("the ratio with its text", ratios[10], ratios[9], kTimesForText);
    report += rows_text("the ratio as an array", ratios[11], ratios[9], kTimesForArray);
    report += fmt::format(
        "D = dgesv of {0} x {0}, here {1:.1f} µs\n", dense.size(), 1e6 * result.unit_seconds);
  }
  std::fwrite(report.data(), 1, report.size(), stdout);
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
