#include "run/sweep.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "report/csv.hpp"
#include "studies/sweep/report/sweep_forecast.hpp"
#include "studies/sweep/report/sweep_rows.hpp"
#include "studies/sweep/task/chunk_runner.hpp"
#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/stored_sweep.hpp"
#include "studies/sweep/task/sweep_result.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

constexpr std::uint64_t kMostJobs = 256;

// Rows in their order to standard output, or the best of them at the end.
class StreamedSweep {
 public:
  StreamedSweep(const SweepTask& task, const SweepHooks& hooks) : task_(task), hooks_(hooks) {
    if (task.metadata.best) {
      best_.emplace(*task.metadata.best);
    }
  }

  RunEnd run(std::uint64_t jobs) {
    std::vector<std::uint64_t> chunks(task_.plan.chunk_count());
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      chunks[i] = i;
    }
    if (!hooks_.write(task_.metadata.heading(0))) {
      return RunEnd::refused;
    }
    const ChunkSink sink{.order = ChunkSink::Order::ascending,
                         .take = [this](ChunkResult result) { return take(std::move(result)); }};
    const RunEnd end =
        run_chunks(task_, chunks, jobs, sink, hooks_, {.total = task_.plan.state_count()});
    return end == RunEnd::complete && !write_best() ? RunEnd::refused : end;
  }

  const SweepCounts& counts() const { return counts_; }

 private:
  bool take(ChunkResult result) {
    counts_.add(result.counts);
    if (!best_) {
      return hooks_.write(result.body);
    }
    best_->add(result.body);
    return true;
  }

  bool write_best() { return !best_ || hooks_.write(best_->take().text); }

  const SweepTask& task_;
  const SweepHooks& hooks_;
  std::optional<BestOfPieces> best_;
  SweepCounts counts_;
};

std::uint64_t thread_count(const SweepOptions& options, Diagnostics& found) {
  if (options.jobs == 0) {
    return std::max(1U, std::thread::hardware_concurrency());
  }
  if (options.jobs > kMostJobs) {
    found.warning("W0101",
                  {},
                  fmt::format("--jobs {} is more than this program uses", options.jobs),
                  fmt::format("{} threads are used; more than the machine has cores do not make "
                              "it faster",
                              kMostJobs));
  }
  return std::min(options.jobs, kMostJobs);
}

void stream(const SweepTask& task,
            const SweepOptions& options,
            const SweepHooks& hooks,
            Diagnostics& found,
            Outcome& outcome) {
  StreamedSweep sweep(task, hooks);
  const RunEnd end = sweep.run(thread_count(options, found));
  if (end == RunEnd::refused) {
    found.error("E0152", {}, "standard output cannot be written");
  } else if (end == RunEnd::complete && !options.is_quiet) {
    outcome.err += sweep_text(task.metadata, sweep.counts());
  }
}

void store(const SweepTask& task,
           const std::string& path,
           const SweepOptions& options,
           const SweepHooks& hooks,
           Diagnostics& found,
           Outcome& outcome) {
  StoredSweep sweep(task, options, input_paths({path}, options.load), hooks, found);
  if (!sweep.prepare()) {
    return;
  }
  if (sweep.was_finished()) {
    outcome.err += options.is_quiet ? "" : fmt::format("{}: complete\n", task.metadata.stem);
    return;
  }
  const RunEnd end = sweep.run(thread_count(options, found));
  if (end == RunEnd::stopped && !options.is_quiet) {
    outcome.err += fmt::format("{}: interrupted; --resume goes on with it\n", task.metadata.stem);
  }
  if (end == RunEnd::complete && sweep.finish() && !options.is_quiet) {
    outcome.err += sweep_text(task.metadata, sweep.counts());
  }
}

// Where the parameters are declared that criteria of the command line name: they are used, though
// the file cannot tell. A name alone is that of a quantity.
std::vector<SourceRange> ranking_parameters(const MechanismDescription& description,
                                            const std::optional<BestChoice>& best) {
  std::vector<SourceRange> places;
  if (!best) {
    return places;
  }
  for (const Criterion& one : best->criteria) {
    const auto parsed = parse_expression(one.by);
    const auto* const formula = std::get_if<Expression>(&parsed);
    for (const auto& parameter : description.parameters) {
      const std::string& name = parameter.name.text;
      if (formula != nullptr && name != one.by &&
          std::ranges::find(formula->names(), name) != formula->names().end()) {
        places.push_back(parameter.name.where);
      }
    }
  }
  return places;
}

// Whether the sweep drops states whose planets cannot be equally spaced.
bool requires_assembly(const MechanismDescription& description) {
  return description.sweep &&
         std::ranges::any_of(description.sweep->require, [](const Requirement& one) {
           return std::ranges::any_of(
               one.condition.questions(),
               [](const ConditionQuestion& question) { return question.word == kAssembles; });
         });
}

// Without saying of those that they are never used, or of the drawn teeth what 'require' asks.
std::optional<Loaded> bind_ranked(MechanismDescription description,
                                  const std::optional<BestChoice>& best,
                                  Diagnostics& found) {
  const std::vector<SourceRange> used = ranking_parameters(description, best);
  const bool is_assembled = requires_assembly(description);
  Diagnostics of_file;
  std::optional<Loaded> loaded = bind_swept(std::move(description), of_file);
  for (const Diagnostic& one : of_file.items()) {
    const bool is_used = one.code == "W0301" && std::ranges::find(used, one.where) != used.end();
    if (!is_used && !(is_assembled && one.code == "W0306")) {
      Diagnostic& kept = one.severity == Severity::error
                             ? found.error(one.code, one.where, one.message, one.hint)
                             : found.warning(one.code, one.where, one.message, one.hint);
      kept.notes = one.notes;
    }
  }
  return loaded;
}

// A sweep gives what it varies its own values, whatever the file is with that of the option.
bool takes_overrides(const MechanismDescription& description,
                     const std::vector<Override>& overrides,
                     Diagnostics& found) {
  bool takes_all = true;
  for (const Override& one : overrides) {
    const std::string name = one.substr(0, one.find('='));
    if (description.sweep &&
        std::ranges::any_of(description.sweep->vary,
                            [&](const VariedParameter& each) { return each.name.text == name; })) {
      found.error("E0101",
                  {},
                  fmt::format("--set '{}': the sweep varies '{}' itself", printable(one), name),
                  fmt::format("remove '{}' from 'vary:', or the option", name));
      takes_all = false;
    }
  }
  return takes_all;
}

// On one core, for a second or so.
void tell_forecast(const SweepTask& task,
                   const SweepOptions& options,
                   Diagnostics& found,
                   Outcome& outcome) {
  constexpr double kSeconds = 1.0;
  const StateSample sample = sample_states(task, kSeconds, options.forecast->clock);
  outcome.out = forecast_text({.metadata = task.metadata,
                               .sampled = sample.counts,
                               .seconds = sample.seconds,
                               .bytes = sample.bytes,
                               .jobs = thread_count(options, found),
                               .words = options.forecast->words});
}

void sweep_into(const std::string& path,
                const SweepOptions& options,
                const SweepHooks& hooks,
                Outcome& outcome) {
  SourceFile source;
  Diagnostics found;
  StyledText messages;
  std::optional<MechanismDescription> description =
      load_description(path, options.load, source, found);
  std::optional<Loaded> loaded =
      description && takes_overrides(*description, options.load.overrides, found)
          ? bind_ranked(*std::move(description), options.best, found)
          : std::nullopt;
  if (loaded) {
    std::optional<SweepTask> task = make_sweep_task(source, *std::move(loaded), options, found);
    if (task) {
      task->tapes = record_tapes(*task);
      Outcome counted;
      if (options.forecast) {
        tell_forecast(*task, options, found, outcome);
      } else {
        options.folder.empty() ? stream(*task, options, hooks, found, counted)
                               : store(*task, path, options, hooks, found, counted);
      }
      messages = std::move(counted.err);
    }
  }
  add_diagnostics(source, found, Strictness::normal, outcome);
  tell(messages, outcome);
}

// Those that the file keeps.
void add_rows(const SolvedState& state,
              const SweepTask& task,
              RowJudge& judge,
              SweepRowText& text,
              SweepTable& table) {
  judge.enter(state.places);
  text.enter(state.places);
  std::vector<double> places;
  for (std::size_t i = 0; i < state.places.size(); ++i) {
    places.push_back(task.plan.axes()[i].count_at(state.places[i]));
  }
  for (const SweepRow& row : state.rows) {
    if (!judge.failing_condition(row)) {
      table.rows.push_back(
          {.places = places, .label = task.cases[row.which].label, .values = row.values});
      text.append(row, table.csv);
    }
  }
}

}  // namespace

std::optional<SweepTable> find_sweep_table(const SourceFile& source,
                                           const MechanismDescription& description,
                                           Diagnostics& found) {
  std::optional<Loaded> loaded = bind_swept(description, found);
  std::optional<SweepTask> task =
      loaded ? make_sweep_task(source, *std::move(loaded), {}, found) : std::nullopt;
  if (!task) {
    return std::nullopt;
  }
  SweepTable table{.states = task->plan.state_count(),
                   .varied = {},
                   .quantities = {},
                   .rows = {},
                   .is_sample = task->plan.draw().has_value()};
  const std::vector<std::string>& titles = task->metadata.titles;
  const auto varied = static_cast<std::ptrdiff_t>(task->plan.axes().size());
  // Then the case; at the end the status.
  table.varied.assign(titles.begin(), titles.begin() + varied);
  table.quantities.assign(titles.begin() + varied + 1, titles.end() - 1);
  if (table.states > kMostSweptStates) {
    return table;
  }
  task->tapes = record_tapes(*task);
  StateSolver solver(*task);
  RowJudge judge(task->plan, task->columns, task->choice);
  SweepRowText text(task->plan, task->cases, task->columns, RowFormat::csv);
  table.csv = csv_line(titles);
  StateWalk walk(task->plan, 0, table.states);
  for (auto states = solver.solve_next(walk); !states.empty(); states = solver.solve_next(walk)) {
    for (const SolvedState& state : states) {
      add_rows(state, *task, judge, text, table);
    }
  }
  return table;
}

Outcome sweep_file(const std::string& path, const SweepOptions& options, const SweepHooks& hooks) {
  Outcome outcome;
  outcome.form = options.diagnostics;
  try {
    sweep_into(path, options, hooks, outcome);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& bug) {
    add_bug(path, bug.what(), outcome);
  }
  return outcome;
}

}  // namespace kinestat
