#include "run/synthesis.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mechanism/bind.hpp"
#include "report/synthesis_report.hpp"
#include "run/each_file.hpp"
#include "run/internal/linkage_files.hpp"
#include "run/internal/synthesis_task.hpp"

namespace kinestat {

namespace {

SynthesisTask solve_task(std::vector<PositionJets> positions, const LinkageLimits& limits) {
  SynthesisTask task;
  task.positions = std::move(positions);
  const int count = position_count(task.positions);
  if (count == 5) {
    task.dyads = solve_burmester(task.positions);
    task.linkages = rank_linkages(task.dyads->dyads, task.positions, limits);
  } else if (count == 4) {
    task.curves = find_curves(task.positions);
  } else if (count == 3) {
    task.straight_paths = find_straight_path_circle(task.positions);
  }
  return task;
}

using Tasks = std::vector<std::vector<PositionJets>>;

bool solve_tasks(const SynthesisValues& values, Diagnostics& found, SynthesisAnalysis& analysis) {
  const std::optional<Tasks> tasks = values.positions_of_tasks({}, found);
  if (!tasks) {
    return false;
  }
  for (const std::vector<PositionJets>& positions : *tasks) {
    analysis.tasks.push_back(solve_task(positions, values.limits()));
  }
  analysis.form = form_of(tasks->front());
  return true;
}

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

// The best choices for the positions of one choice of angles.
void select_task(const SynthesisValues& values, std::size_t task, SynthesisAnalysis& analysis) {
  constexpr int kKept = 5;
  const std::vector<SelectionRange> ranges = values.ranges();
  const TaskMaker make_task =
      [&](std::span<const double> numbers) -> std::optional<std::vector<PositionJets>> {
    Diagnostics unsaid;
    auto tasks = values.positions_of_tasks(values.choice_of(numbers), unsaid);
    return tasks ? std::optional((*tasks)[task]) : std::nullopt;
  };
  const Selection selection = select_linkages(ranges, make_task, values.limits(), kKept);
  analysis.selection->samples += selection.samples;
  analysis.selection->with_linkage += selection.with_linkage;
  analysis.selection->usable += selection.usable;
  std::vector<SelectedLinkage> shown = selection.best;
  if (selection.nearest) {
    shown.push_back(*selection.nearest);
  }
  for (const SelectedLinkage& one : shown) {
    analysis.tasks.push_back(solve_task(*make_task(one.choice), values.limits()));
    analysis.tasks.back().choice = values.choice_of(one.choice);
  }
}

bool select_tasks(const SynthesisValues& values,
                  const MechanismDescription& description,
                  Diagnostics& found,
                  SynthesisAnalysis& analysis) {
  const std::optional<Tasks> possible = find_possible_tasks(values, values.ranges(), found);
  if (!possible) {
    return false;
  }
  analysis.form = form_of(possible->front());
  if (position_count(possible->front()) != 5) {
    found.error("E0305",
                description.synthesis->vary.front().where,
                fmt::format("'vary' needs a task of five positions, and this is {}", analysis.form),
                "add a position or an order of contact, or remove 'vary'");
    return false;
  }
  analysis.selection = SelectionCounts{};
  for (std::size_t task = 0; task < possible->size(); ++task) {
    select_task(values, task, analysis);
  }
  return true;
}

// Empty iff an error was added.
std::optional<SynthesisAnalysis> find_synthesis(const std::string& path,
                                                MechanismDescription description,
                                                Diagnostics& found) {
  if (!check(description, found)) {
    return std::nullopt;
  }
  if (!description.synthesis) {
    found.error("E0303",
                {},
                "the file has no section 'synthesis'",
                "'kinestat new synthesis' writes an example");
    return std::nullopt;
  }
  SynthesisAnalysis analysis;
  analysis.file = path;
  const SynthesisValues values(description);
  const bool is_right = description.synthesis->vary.empty()
                            ? solve_tasks(values, found, analysis)
                            : select_tasks(values, description, found, analysis);
  if (!is_right) {
    return std::nullopt;
  }
  analysis.curve_count = values.curve_count().value_or(analysis.curve_count);
  analysis.description = std::move(description);
  return analysis;
}

}  // namespace

Outcome synthesize_files(const std::vector<std::string>& paths,
                         WrittenLinkages written,
                         const AnalyseOptions& options) {
  return report_on_each_file(
      paths,
      options,
      [&](const std::string& path, const ReportForms& forms, SourceFile& source, Diagnostics& found)
          -> std::optional<FileReport> {
        auto description = load_description(path, options.load, source, found);
        auto analysis =
            description ? find_synthesis(path, *std::move(description), found) : std::nullopt;
        if (!analysis) {
          return std::nullopt;
        }
        if (!options.output.folder.empty()) {
          write_linkages(*analysis, written, options.output, found);
        }
        return make_synthesis_report(*analysis, forms, found);
      });
}

}  // namespace kinestat
