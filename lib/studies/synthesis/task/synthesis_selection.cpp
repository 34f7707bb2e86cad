#include "studies/synthesis/task/synthesis_selection.hpp"

#include <functional>
#include <utility>

#include <fmt/format.h>

#include "studies/synthesis/task/for_each_on_threads.hpp"

namespace kinestat {

namespace {

using Tasks = std::vector<std::vector<PositionJets>>;

// The tasks of some choice. Where all that are tried contradict themselves, the first says why.
std::optional<Tasks> find_possible_tasks(const SynthesisValues& values,
                                         std::span<const SelectionRange> ranges,
                                         Diagnostics& found) {
  constexpr int kTried = 7;
  Diagnostics unsaid;
  for (int i = 0; i < kTried; ++i) {
    std::vector<double> numbers;
    for (const SelectionRange& range : ranges) {
      numbers.push_back(range.from + (range.to - range.from) * (i + 0.5) / kTried);
    }
    if (auto tasks = values.positions_of_tasks(values.choice_of(numbers), unsaid)) {
      return tasks;
    }
  }
  const Diagnostic& why = unsaid.items().front();
  found.error(why.code, why.where, why.message, why.hint);
  return std::nullopt;
}

void add_counts(const Selection& selection, SynthesisAnalysis& analysis) {
  for (SelectionCounts* counts : {&*analysis.selection, &analysis.selections.back().counts}) {
    counts->samples += selection.samples;
    counts->with_linkage += selection.with_linkage;
    counts->usable += selection.usable;
    for (std::size_t i = 0; i < kDefectCount; ++i) {
      counts->defects[i] += selection.defects[i];
    }
    for (std::size_t i = 0; i < kMissingCount; ++i) {
      counts->missing[i] += selection.missing[i];
    }
  }
}

// What a report shows of a selection: the best, or else what comes nearest.
std::vector<SelectedLinkage> shown_of(const Selection& selection) {
  std::vector<SelectedLinkage> shown = selection.best;
  if (selection.nearest) {
    shown.push_back(*selection.nearest);
  }
  return shown;
}

// The best choices for the positions of one choice of angles.
void select_task(const SynthesisValues& values,
                 std::size_t task,
                 const ForEach& for_each,
                 SynthesisAnalysis& analysis) {
  const TaskMaker make_task = [&](std::span<const double> numbers) {
    Diagnostics unsaid;
    return values.positions_of_task(task, values.choice_of(numbers), unsaid);
  };
  const Selection selection = select_linkages(values.ranges(),
                                              candidates_of(make_task, values.limits()),
                                              kBestLinkages,
                                              for_each,
                                              shortfalls_of(make_task));
  add_counts(selection, analysis);
  std::vector<std::vector<double>> choices;
  for (const SelectedLinkage& one : shown_of(selection)) {
    choices.push_back(one.choice);
  }
  if (selection.nearest_choice) {
    choices.push_back(*selection.nearest_choice);
  }
  for (const std::vector<double>& choice : choices) {
    analysis.tasks.push_back(solve_task(*make_task(choice), values.limits()));
    analysis.tasks.back().choice = values.choice_of(choice);
  }
}

// Three or four positions: the dyads are those of the circle points chosen.
void select_circle_points(const SynthesisValues& values,
                          const std::vector<PositionJets>& positions,
                          const ForEach& for_each,
                          SynthesisAnalysis& analysis) {
  const CirclePointChoice choice(positions, *values.circle_points());
  const LinkageLimits limits = values.limits();
  const CandidateMaker make = [&](std::span<const double> numbers) {
    return choice.candidate(numbers, limits);
  };
  const std::vector<SelectionRange> ranges = choice.ranges(values.samples());
  if (ranges.empty()) {
    analysis.tasks.push_back(solve_task(positions, limits));
    return;
  }
  const Selection selection =
      select_linkages(ranges, make, kBestLinkages, for_each, {}, ChoiceHalves::alike);
  add_counts(selection, analysis);
  for (const SelectedLinkage& one : shown_of(selection)) {
    SynthesisTask task;
    task.choice = SynthesisChoice{};
    task.positions = positions;
    task.dyads = BurmesterSolution{.dyads = choice.dyads(one.choice)};
    if (choice.curves()) {
      task.dyads->digits = choice.curves()->digits;
      task.dyads->reciprocal_condition = choice.curves()->reciprocal_condition;
    }
    task.linkages = rank_linkages(task.dyads->dyads, positions, limits);
    analysis.tasks.push_back(std::move(task));
  }
}

}  // namespace

std::optional<Tasks> find_selection_tasks(const SynthesisValues& values,
                                          const SynthesisDescription& task,
                                          Diagnostics& found) {
  if (values.circle_points()) {
    return values.positions_of_tasks({}, found);
  }
  std::optional<Tasks> possible = find_possible_tasks(values, values.ranges(), found);
  if (possible && position_count(possible->front()) != 5) {
    found.error("E0305",
                task.vary.front().where,
                fmt::format("'{}' is chosen in tasks of five positions, and this is {}",
                            word_of(task.vary.front().which),
                            form_of(possible->front())),
                "give it a number and let 'circle_points' vary, or add positions");
    return std::nullopt;
  }
  return possible;
}

bool select_tasks(const SynthesisValues& values,
                  std::uint64_t jobs,
                  Diagnostics& found,
                  SynthesisAnalysis& analysis) {
  const std::optional<Tasks> possible =
      find_selection_tasks(values, *analysis.description.synthesis, found);
  if (!possible) {
    return false;
  }
  const bool chooses_points = values.circle_points().has_value();
  analysis.form = form_of(possible->front());
  const ForEach for_each = for_each_on_threads(jobs);
  analysis.selection = SelectionCounts{};
  for (std::size_t task = 0; task < possible->size(); ++task) {
    AngleSelection& selection = analysis.selections.emplace_back();
    selection.first_task = analysis.tasks.size();
    for (const PositionJets& position : (*possible)[task]) {
      selection.angles.push_back(position.angle[0]);
    }
    if (chooses_points) {
      select_circle_points(values, (*possible)[task], for_each, analysis);
    } else {
      select_task(values, task, for_each, analysis);
    }
  }
  return true;
}

}  // namespace kinestat
