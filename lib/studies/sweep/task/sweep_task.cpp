#include "studies/sweep/task/sweep_task.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cases/solve_cases.hpp"
#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "files/output.hpp"
#include "io/stored_chunk.hpp"
#include "studies/shift/task/gear_cases.hpp"
#include "studies/sweep/report/sweep_array.hpp"

namespace kinestat {

namespace {

// Which cases of the mechanism are run: those that the sweep names, or all that the file writes,
// all gears and whatever else has a label. Combinations that are no gears with the parameters of
// the file get a case here, for in other states they may be.
class CaseChoice {
 public:
  CaseChoice(const SweepDescription& sweep, Loaded& loaded, Diagnostics& found)
      : sweep_(sweep),
        shift_(loaded.shift),
        description_(loaded.description),
        mechanism_(loaded.mechanism),
        found_(found) {}

  void run() {
    if (sweep_.cases.empty() && sweeps_motion_alone(description_)) {
      choose_case_of_motion();
      return;
    }
    if (sweep_.cases.empty()) {
      choose_all();
    }
    for (const Name& label : sweep_.cases) {
      choose(label);
    }
    if (chosen.empty() && !found_.has_errors()) {
      found_.error("E0303",
                   sweep_.where,
                   "the file has neither cases nor gears, so that the sweep has nothing to analyse",
                   "add 'cases:' with what is known of motions and actions, or 'shift:'");
    }
  }

  std::vector<std::size_t> chosen;
  std::vector<std::optional<SweptGear>> gears;

 private:
  // That of the motion itself, if it has any.
  void choose_case_of_motion() {
    if (const std::optional<Name>& label = description_.motion->label) {
      choose(*label);
    } else {
      gears.emplace_back();
    }
  }

  void choose_all() {
    const std::size_t count = mechanism_.cases.size();
    for (std::size_t i = 0; i < count; ++i) {
      add(i,
          shift_ ? find_combination(mechanism_.cases[i].label, mechanism_, shift_->plan)
                 : std::nullopt);
    }
    for (std::size_t l = 0; shift_ && l < shift_->plan.labels.size(); ++l) {
      const std::string& label = shift_->plan.labels[l].text;
      if (std::ranges::find(mechanism_.cases, label, &Case::label) == mechanism_.cases.end()) {
        add_case(*find_combination(label, mechanism_, shift_->plan));
      }
    }
  }

  void choose(const Name& label) {
    const std::vector<Case>& cases = mechanism_.cases;
    const auto at = std::ranges::find(cases, label.text, &Case::label);
    std::optional<NamedShiftState> gear =
        shift_ ? find_combination(label.text, mechanism_, shift_->plan) : std::nullopt;
    if (at != cases.end()) {
      add(static_cast<std::size_t>(at - cases.begin()), std::move(gear));
    } else {
      KINESTAT_EXPECTS(gear.has_value());  // or the check of the section would have complained
      add_case(*std::move(gear));
    }
  }

  void add(std::size_t which, std::optional<NamedShiftState> gear) {
    chosen.push_back(which);
    gears.emplace_back();
    if (gear) {
      GearCase described = gear_case(*gear, shift_->plan);
      gears.back() = {.state = *std::move(gear), .described = std::move(described)};
    }
  }

  void add_case(NamedShiftState gear) {
    add_gear_cases({gear_case(gear, shift_->plan)}, shift_->plan, description_, mechanism_);
    add(mechanism_.cases.size() - 1, std::move(gear));
  }

  const SweepDescription& sweep_;
  const std::optional<ShiftAnalysis>& shift_;
  MechanismDescription& description_;
  Mechanism& mechanism_;
  Diagnostics& found_;
};

bool has_sweep(const MechanismDescription& description, Diagnostics& found) {
  if (!description.sweep) {
    found.error("E0303",
                {},
                "the file has no section 'sweep'",
                "add for example sweep: {vary: {N1: {from: 15, to: 40, step: 1}}, report: "
                "[ratio]}; 'kinestat help sweeps' shows more");
  }
  return description.sweep.has_value();
}

// Sections that say nothing about a single state.
MechanismDescription without_tasks(MechanismDescription description, bool needs_motion) {
  description.sweep.reset();
  description.dynamics.reset();
  if (!needs_motion) {
    description.motion.reset();
  }
  description.synthesis.reset();
  description.published.clear();
  return description;
}

// JSON and tables can do with two columns of one title.
void refuse_twin_titles(const SweepDescription& sweep,
                        const std::vector<std::string>& titles,
                        Diagnostics& found) {
  for (auto one = titles.begin(); one != titles.end(); ++one) {
    if (std::find(one + 1, titles.end(), *one) != titles.end()) {
      found.error("E0306",
                  sweep.where,
                  fmt::format("two columns of the rows are called '{}', and the fields of an array "
                              "need different names",
                              printable(*one)),
                  "give the parameter or the actuator another name, or the rows --format csv");
    }
  }
}

// Everything that decides the bytes of the rows.
std::string plan_text(const SourceFile& source,
                      const SweepOptions& options,
                      const MechanismDescription& description,
                      const SweepPlan& plan) {
  std::string text = fmt::format("kinestat {} sweep 1\n", kVersion);
  for (const Override& one : options.load.overrides) {
    text += fmt::format("set {}:{}\n", one.size(), one);
  }
  for (const CurveDescription& one : description.curves) {
    if (!one.table.empty()) {
      text += fmt::format("curve {}:{} {}\n", one.name.text.size(), one.name.text, one.table_hash);
    }
  }
  text += fmt::format("format {}\nchunks {} of {}\n",
                      word_of(options.format),
                      plan.chunk_count(),
                      plan.chunk_size());
  if (options.best) {
    text += fmt::format("best {} by", options.best->count);
    for (const Criterion& one : options.best->criteria) {
      text += fmt::format(" {}:{}", one.text().size(), one.text());
    }
    text += '\n';
  }
  return text + source.text;
}

// Of each row of a state the case that moves it: the same in which it stands.
std::vector<int> moving_cases(const CaseChoice& choice) {
  std::vector<int> cases;
  for (const std::size_t which : choice.chosen) {
    cases.push_back(static_cast<int>(which));
  }
  if (cases.empty()) {
    cases.push_back(-1);
  }
  return cases;
}

SweepMetadata metadata_of(const SourceFile& source,
                          const SweepDescription& sweep,
                          const SweepOptions& options,
                          const SweepTask& task) {
  SweepMetadata metadata;
  metadata.version = std::string(kVersion);
  metadata.plan = hash_of(plan_text(source, options, task.description, task.plan));
  metadata.stem = report_stem(source.path);
  metadata.name = task.description.name;
  metadata.format = options.format;
  metadata.titles = sweep_titles(task.plan, task.columns);
  if (options.format == RowFormat::npy) {
    metadata.dtype = sweep_dtype(task.plan, task.columns);
  }
  for (const Case& which : task.cases) {
    metadata.cases.push_back(which.label);
  }
  for (const PlannedRequirement& one : task.plan.requirements()) {
    metadata.requirements.push_back(one.text);
  }
  for (const Requirement& one : sweep.keep) {
    metadata.keep.push_back(one.condition.text());
  }
  metadata.states = task.plan.state_count();
  metadata.chunks = task.plan.chunk_count();
  metadata.best = options.best;
  if (task.plan.draw()) {
    metadata.sample = task.plan.draw()->choice();
  }
  return metadata;
}

// A gear is decided anew by each state, and a motion takes its speeds and loads from a case of the
// file.
void refuse_moving_gears(const std::optional<SweptMotion>& motion,
                         const CaseChoice& choice,
                         const std::vector<Case>& cases,
                         const SweepDescription& sweep,
                         Diagnostics& found) {
  for (std::size_t i = 0; motion && motion->is_of_case && i < cases.size(); ++i) {
    if (choice.gears[i]) {
      found.error("E0305",
                  sweep.where,
                  fmt::format("the sweep reports speeds or loads of a motion, but '{}' is a gear, "
                              "not a case of the file",
                              printable(cases[i].label)),
                  "name cases under 'cases:' of 'sweep'");
      return;
    }
  }
}

void find_usually_solved(SweepTask& task) {
  for (const CaseAnalysis& one : solve_some_cases(task.mechanism, task.cases)) {
    task.is_usually_solved.push_back((!one.motion || one.motion->status == SolveStatus::solved) &&
                                     (!one.action || one.action->status == SolveStatus::solved));
  }
}

}  // namespace

std::vector<Case> chosen_cases(const SweepTask& task, const Mechanism& mechanism) {
  std::vector<Case> cases(task.chosen.empty() ? 1 : 0);
  for (const std::size_t i : task.chosen) {
    cases.push_back(mechanism.cases[i]);
    cases.back().asks_actions = cases.back().asks_actions && task.has_statics;
  }
  return cases;
}

std::optional<SweepTask> make_sweep_task(const SourceFile& source,
                                         Loaded loaded,
                                         const SweepOptions& options,
                                         Diagnostics& found) {
  const MechanismDescription& description = loaded.description;
  if (!has_sweep(description, found)) {
    return std::nullopt;
  }
  const int errors_before = found.error_count();
  const SweepDescription sweep = *description.sweep;
  CaseChoice choice(sweep, loaded, found);
  choice.run();
  std::vector<Case> cases;
  for (const std::size_t i : choice.chosen) {
    cases.push_back(loaded.mechanism.cases[i]);
  }
  std::optional<MotionColumnSearch> of_motion;
  auto columns = find_sweep_columns(
      description,
      loaded.mechanism,
      cases,
      [&](const Name& name) {
        if (!of_motion) {
          of_motion.emplace(description, loaded.mechanism, moving_cases(choice), found);
        }
        return of_motion->find(name);
      },
      found);
  std::optional<SweptMotion> motion;
  if (of_motion && found.error_count() == errors_before) {
    motion = of_motion->take();
    refuse_moving_gears(motion, choice, cases, sweep, found);
  }
  if (found.error_count() > errors_before) {
    return std::nullopt;
  }
  SweepPlan plan(description);
  std::optional<RowChoice> rows = find_row_choice(description, plan, *columns, options.best, found);
  if (!rows) {
    return std::nullopt;
  }
  const bool has_motion_alone = sweeps_motion_alone(description);
  SweepTask task{.description = without_tasks(description, motion.has_value()),
                 .mechanism = std::move(loaded.mechanism),
                 .plan = std::move(plan),
                 .chosen = std::move(choice.chosen),
                 .cases = {},
                 .shift = {},
                 .gears = std::move(choice.gears),
                 .is_usually_solved = {},
                 .columns = *std::move(columns),
                 .motion = std::move(motion),
                 .has_motion_alone = has_motion_alone,
                 .has_statics = false,
                 .choice = *std::move(rows),
                 .tapes = {},
                 .metadata = {}};
  task.has_statics = std::ranges::any_of(
      task.columns, [](const SweepColumn& one) { return needs_statics(one.kind); });
  if (loaded.shift) {
    task.forward = loaded.shift->solution.table.forward;
    task.shift = std::move(loaded.shift->plan);
  }
  task.cases = chosen_cases(task, task.mechanism);
  if (has_motion_alone) {
    task.is_usually_solved.assign(task.cases.size(), true);
  } else {
    find_usually_solved(task);
  }
  task.metadata = metadata_of(source, sweep, options, task);
  if (options.format == RowFormat::npy) {
    refuse_twin_titles(sweep, task.metadata.titles, found);
  }
  return found.error_count() > errors_before ? std::nullopt : std::optional(std::move(task));
}

}  // namespace kinestat
