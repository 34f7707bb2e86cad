#include "run/duty.hpp"

#include <filesystem>
#include <optional>

#include "cases/case_findings.hpp"
#include "files/each_file.hpp"
#include "files/load_file.hpp"
#include "io/read_file.hpp"
#include "mechanism/duty/duty_table.hpp"
#include "studies/duty/report/duty_report.hpp"

namespace kinestat {

namespace {

// A cycle of a line a tenth of a second for a day has so many bytes.
constexpr std::size_t kMostTableBytes = std::size_t{1} << 26U;

// Of the section beside the mechanism file, or of the command line.
std::optional<std::string> table_path(const std::string& file,
                                      const std::string& table,
                                      const MechanismDescription& description) {
  if (!table.empty()) {
    return table;
  }
  if (!description.duty || !description.duty->file) {
    return std::nullopt;
  }
  return (std::filesystem::path(file).parent_path() / description.duty->file->text).string();
}

void add_table(const std::string& path, const Loaded& loaded, DutyPlan& plan, Diagnostics& found) {
  const auto source = read_file(path, ReadLimits::for_size(kMostTableBytes), found);
  if (source) {
    add_duty_table(loaded.description, loaded.mechanism, path, source->text, plan, found);
  }
}

// Empty iff an error was added.
std::optional<DutyPlan> find_plan(const ReportedFile& file,
                                  const std::string& table,
                                  Loaded& loaded,
                                  Diagnostics& found) {
  if (!loaded.description.duty && table.empty()) {
    found.error("E0303",
                {},
                "the file has no section 'duty'",
                "add duty: {points: [{case: …, input_motion: …, input_action: …, duration: …}]}, "
                "or give a table of points with --cycle");
    return std::nullopt;
  }
  const int errors_before = found.error_count();
  if (!loaded.description.duty) {
    loaded.description.duty.emplace();
  }
  if (!table.empty()) {
    loaded.description.duty->points.clear();
  }
  std::optional<DutyPlan> plan = bind_duty(loaded.description, loaded.mechanism, found);
  const std::optional<std::string> path = table_path(file.path, table, loaded.description);
  if (plan && path) {
    add_table(*path, loaded, *plan, found);
  }
  return found.error_count() == errors_before ? std::move(plan) : std::nullopt;
}

// Why points have no answer is what an analysis of their case says.
void add_unanswered(const Loaded& loaded, const DutySolution& duty, Diagnostics& found) {
  const JudgedFile judged{
      .description = loaded.description, .mechanism = loaded.mechanism, .shift = loaded.shift};
  for (const UnansweredCase& one : duty.unanswered) {
    const CaseFindings findings = find_case_findings(judged, one.analysis);
    for (const CaseFinding& finding : findings.items()) {
      add(finding, found);
    }
  }
}

}  // namespace

Outcome duty_of_files(const std::vector<std::string>& paths,
                      const std::string& table,
                      const AnalyseOptions& options) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    std::optional<Loaded> loaded = load(file.path, options.load, file.source, file.found);
    if (!loaded) {
      return std::nullopt;
    }
    const std::optional<DutyPlan> plan = find_plan(file, table, *loaded, file.found);
    if (!plan) {
      return std::nullopt;
    }
    const DutySolution duty = solve_duty(loaded->mechanism, *plan);
    add_unanswered(*loaded, duty, file.found);
    return make_duty_report({.file = file.path,
                             .description = loaded->description,
                             .mechanism = loaded->mechanism,
                             .plan = *plan,
                             .duty = duty,
                             .found = &file.found},
                            file.forms);
  });
}

}  // namespace kinestat
