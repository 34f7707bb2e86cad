#include "studies/synthesis/task/synthesis_selection.hpp"

#include <functional>
#include <utility>

#include <fmt/format.h>

#include "math/numbers/for_each_number.hpp"

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
  analysis.selections.back().counts += selection.counts;
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

// Three or four positions: the dyads are given, or those of the points chosen. False iff an error
// was added.
bool select_dyads(const SynthesisValues& values,
                  const std::vector<PositionJets>& positions,
                  const ForEach& for_each,
                  Diagnostics& found,
                  SynthesisAnalysis& analysis) {
  const std::optional<std::vector<Dyad>> given = values.given_dyads(positions, found);
  if (!given) {
    return false;
  }
  const LinkageLimits limits = values.limits();
  const DyadChoice choice(positions,
                          *values.choice_area(),
                          given->empty() ? std::nullopt : std::optional(given->front()),
                          limits.function);
  const CandidateMaker make = [&](std::span<const double> numbers) {
    return choice.candidate(numbers, limits);
  };
  const std::vector<SelectionRange> ranges = choice.ranges(values.samples());
  if (ranges.empty()) {
    analysis.tasks.push_back(solve_task(positions, limits, {}, *given));
    return true;
  }
  const Selection selection =
      select_linkages(ranges, make, kBestLinkages, for_each, {}, choice.halves());
  analysis.selections.back().counts += selection.counts;
  for (const SelectedLinkage& one : shown_of(selection)) {
    SynthesisTask task;
    task.choice = SynthesisChoice{};
    task.positions = positions;
    add_dyads(choice.dyads(one.choice), choice.curves(), limits, task);
    analysis.tasks.push_back(std::move(task));
  }
  return true;
}

}  // namespace

std::optional<Tasks> find_selection_tasks(const SynthesisValues& values,
                                          const SynthesisDescription& task,
                                          Diagnostics& found) {
  if (values.choice_area()) {
    return values.positions_of_tasks({}, found);
  }
  std::optional<Tasks> possible = find_possible_tasks(values, values.ranges(), found);
  if (possible && position_count(possible->front()) != 5) {
    const FreeNumber which = task.vary.front().which;
    const bool has_number = which == FreeNumber::m || which == FreeNumber::free_point;
    found.error("E0305",
                task.vary.front().where,
                fmt::format("'{}' is chosen in tasks of five positions, and this is {}",
                            word_of(which),
                            form_of(possible->front())),
                fmt::format("{} and let 'circle_points' vary, or add positions",
                            has_number ? "give it a number"
                                       : "give 'free_point' and 'm' of 'curvature' instead"));
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
  const bool chooses_dyads = values.choice_area().has_value();
  analysis.form = form_of(possible->front());
  const ForEach for_each = for_each_on_threads(jobs);
  analysis.selection = SelectionCounts{};
  for (std::size_t task = 0; task < possible->size(); ++task) {
    AngleSelection& selection = analysis.selections.emplace_back();
    selection.first_task = analysis.tasks.size();
    for (const PositionJets& position : (*possible)[task]) {
      selection.angles.push_back(position.angle[0]);
    }
    if (!chooses_dyads) {
      select_task(values, task, for_each, analysis);
    } else if (!select_dyads(values, (*possible)[task], for_each, found, analysis)) {
      return false;
    }
  }
  for (const AngleSelection& one : analysis.selections) {
    *analysis.selection += one.counts;
  }
  return true;
}

}  // namespace kinestat
