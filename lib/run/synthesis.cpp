#include "run/synthesis.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "mechanism/bind.hpp"
#include "report/synthesis_report.hpp"
#include "run/each_file.hpp"
#include "run/internal/synthesis_task.hpp"

namespace kinestat {

namespace {

bool fits(LinkageKind wanted, LinkageType type) {
  switch (wanted) {
    case LinkageKind::any:
      return true;
    case LinkageKind::four_bar:
      return type == LinkageType::four_bar;
    case LinkageKind::slider_crank:
      return type == LinkageType::slider_crank;
    case LinkageKind::inverted_slider_crank:
      return type == LinkageType::inverted_slider_crank;
  }
  return false;
}

SynthesisTask solve_task(std::vector<PositionJets> positions,
                         const LinkageLimits& limits,
                         LinkageKind wanted) {
  SynthesisTask task;
  task.positions = std::move(positions);
  const int count = position_count(task.positions);
  if (count == 5) {
    task.dyads = solve_burmester(task.positions);
    task.linkages = rank_linkages(task.dyads->dyads, task.positions, limits);
    std::erase_if(task.linkages,
                  [&](const LinkageCandidate& one) { return !fits(wanted, one.linkage.type()); });
  } else if (count == 4) {
    task.curves = find_curves(task.positions);
  } else if (count == 3) {
    task.straight_paths = find_straight_path_circle(task.positions);
  }
  return task;
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
  const SynthesisValues values(description);
  const std::optional<std::vector<std::vector<PositionJets>>> tasks =
      values.positions_of_tasks(found);
  if (!tasks) {
    return std::nullopt;
  }
  SynthesisAnalysis analysis;
  for (const std::vector<PositionJets>& positions : *tasks) {
    analysis.tasks.push_back(
        solve_task(positions, values.limits(), description.synthesis->linkage));
  }
  analysis.file = path;
  analysis.curve_count = values.curve_count().value_or(analysis.curve_count);
  analysis.description = std::move(description);
  return analysis;
}

}  // namespace

Outcome synthesize_files(const std::vector<std::string>& paths, const AnalyseOptions& options) {
  const ReportForms forms = stream_forms(options.format, paths.size());
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    SourceFile source;
    Diagnostics found;
    std::optional<MechanismDescription> description =
        load_description(path, options.overrides, source, found);
    if (description) {
      if (const auto analysis = find_synthesis(path, *std::move(description), found)) {
        add_to_stream(make_synthesis_report(*analysis, forms, found), options, outcome);
      }
    }
    add_diagnostics(source, found, options.strictness, outcome);
  });
}

}  // namespace kinestat
