#include "run/internal/sweep_task.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "io/chunk_record.hpp"
#include "run/output.hpp"
#include "run/solve_cases.hpp"

namespace kinestat {

namespace {

std::vector<std::string> labels_of(const std::vector<Case>& cases) {
  std::vector<std::string> labels;
  for (const Case& which : cases) {
    labels.push_back(which.label);
  }
  return labels;
}

// The labels that the sweep names, or all.
std::vector<std::size_t> choose_cases(const SweepDescription& sweep,
                                      const std::vector<Case>& cases,
                                      Diagnostics& found) {
  std::vector<std::size_t> chosen;
  for (const Name& label : sweep.cases) {
    const auto at = std::ranges::find(cases, label.text, &Case::label);
    if (at == cases.end()) {
      found.error("E0315",
                  label.where,
                  fmt::format("gear '{}' of 'sweep' is not analysed yet", printable(label.text)),
                  fmt::format("write it as a case; cases are {}", plain_list(labels_of(cases))));
      continue;
    }
    chosen.push_back(static_cast<std::size_t>(at - cases.begin()));
  }
  for (std::size_t i = 0; i < cases.size() && sweep.cases.empty(); ++i) {
    chosen.push_back(i);
  }
  if (cases.empty()) {
    found.error("E0303",
                sweep.where,
                "the file has no cases, so that the sweep has nothing to analyse",
                "add 'cases:' with what is known of motions and actions");
  }
  return chosen;
}

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
MechanismDescription without_tasks(MechanismDescription description) {
  description.sweep.reset();
  description.motion.reset();
  description.synthesis.reset();
  description.shift.reset();  // its gears are cases by now
  description.published.clear();
  return description;
}

// Whether one engages depends on the state, and the gears of a sweep are those of the file.
void refuse_freewheels(const MechanismDescription& description, Diagnostics& found) {
  for (const CouplingDescription& coupling : description.couplings) {
    if (coupling.one_way) {
      found.error("E0315",
                  coupling.name.where,
                  fmt::format("freewheel '{}' in a sweep is not analysed yet", coupling.name.text),
                  "remove 'one_way' for the sweep, which then shows the torque of the engaged "
                  "element; 'kinestat shift --set' decides single states");
    }
  }
}

// A sweep gives what it varies its own values.
void refuse_overridden_axes(const SweepDescription& sweep,
                            const std::vector<Override>& overrides,
                            Diagnostics& found) {
  for (const Override& one : overrides) {
    const std::string name = one.substr(0, one.find('='));
    if (std::ranges::any_of(sweep.vary,
                            [&](const VariedParameter& each) { return each.name.text == name; })) {
      found.error("E0101",
                  {},
                  fmt::format("--set '{}': the sweep varies '{}' itself", printable(one), name),
                  fmt::format("remove '{}' from 'vary:', or the option", name));
    }
  }
}

// By the name in the file, without the unit.
std::optional<std::size_t> find_key(const std::vector<SweepQuantity>& quantities,
                                    const TopChoice& top,
                                    Diagnostics& found) {
  const auto at = std::ranges::find(quantities, top.by, &SweepQuantity::name);
  if (at != quantities.end()) {
    return static_cast<std::size_t>(at - quantities.begin());
  }
  std::vector<std::string> names;
  for (const SweepQuantity& quantity : quantities) {
    names.push_back(quantity.name);
  }
  const std::string guess = did_you_mean(top.by, names);
  found.error("E0101",
              {},
              fmt::format("--by '{}': the rows have no such quantity", printable(top.by)),
              fmt::format("{}{}they have {}", guess, guess.empty() ? "" : " ", plain_list(names)));
  return std::nullopt;
}

// Everything that decides the bytes of the rows.
std::string plan_text(const SourceFile& source,
                      const SweepOptions& options,
                      const SweepPlan& plan) {
  std::string text = fmt::format("kinestat {} sweep 1\n", kVersion);
  for (const Override& one : options.overrides) {
    text += fmt::format("set {}:{}\n", one.size(), one);
  }
  text += fmt::format("format {}\nchunks {} of {}\n",
                      options.format == RowFormat::csv ? "csv" : "json",
                      plan.chunk_count(),
                      plan.chunk_size());
  if (options.top) {
    text += fmt::format("top {} by {} {}\n",
                        options.top->count,
                        options.top->by,
                        options.top->order == RankOrder::largest ? "largest" : "smallest");
  }
  return text + source.text;
}

SweepHeader header_of(const SourceFile& source,
                      const SweepOptions& options,
                      const SweepTask& task) {
  const SweepRowText text(task.plan, task.cases, task.quantities, options.format);
  SweepHeader header;
  header.version = std::string(kVersion);
  header.plan = hash_of(plan_text(source, options, task.plan));
  header.stem = report_stem(source.path);
  header.name = task.description.name;
  header.format = options.format;
  header.titles = text.titles();
  header.heading = text.header();
  header.signature = text.signature();
  for (const PlannedRequirement& one : task.plan.requirements()) {
    header.requirements.push_back(one.text);
  }
  header.states = task.plan.state_count();
  header.chunks = task.plan.chunk_count();
  header.top = options.top;
  return header;
}

}  // namespace

std::vector<Case> sweepable_cases(const Mechanism& mechanism) {
  return mechanism.cases;
}

std::vector<Case> chosen_cases(const SweepTask& task, const Mechanism& mechanism) {
  const std::vector<Case> all = sweepable_cases(mechanism);
  std::vector<Case> cases;
  for (const std::size_t i : task.chosen) {
    cases.push_back(all[i]);
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
  refuse_freewheels(description, found);
  refuse_overridden_axes(*description.sweep, options.overrides, found);
  const std::vector<Case> all = sweepable_cases(loaded.mechanism);
  std::vector<std::size_t> chosen = choose_cases(*description.sweep, all, found);
  std::vector<Case> cases;
  std::ranges::transform(chosen, std::back_inserter(cases), [&](std::size_t i) { return all[i]; });
  auto quantities = find_sweep_quantities(description, loaded.mechanism, cases, found);
  std::optional<std::size_t> key;
  if (quantities && options.top) {
    key = find_key(*quantities, *options.top, found);
  }
  if (found.error_count() > errors_before) {
    return std::nullopt;
  }
  SweepPlan plan(description);
  SweepTask task{.description = without_tasks(description),
                 .mechanism = std::move(loaded.mechanism),
                 .plan = std::move(plan),
                 .chosen = std::move(chosen),
                 .cases = {},
                 .is_usually_solved = {},
                 .quantities = *std::move(quantities),
                 .has_statics = false,
                 .key = key,
                 .tapes = {},
                 .header = {}};
  task.has_statics = std::ranges::any_of(
      task.quantities, [](const SweepQuantity& one) { return needs_statics(one.kind); });
  task.cases = chosen_cases(task, task.mechanism);
  for (const CaseAnalysis& one : solve_some_cases(task.mechanism, task.cases)) {
    task.is_usually_solved.push_back((!one.motion || one.motion->status == SolveStatus::solved) &&
                                     (!one.action || one.action->status == SolveStatus::solved));
  }
  task.header = header_of(source, options, task);
  return task;
}

}  // namespace kinestat
