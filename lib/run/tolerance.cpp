#include "run/tolerance.hpp"

#include <optional>
#include <utility>

#include "cases/findings/case_findings.hpp"
#include "cases/solve_cases.hpp"
#include "files/each_file.hpp"
#include "studies/tolerance/task/find_tolerance.hpp"

namespace kinestat {

Outcome tolerance_of_files(const std::vector<std::string>& paths,
                           const ToleranceChoice& choice,
                           const AnalyseOptions& options) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    std::optional<Loaded> loaded = load(file.path, options.load, file.source, file.found);
    if (!loaded) {
      return std::nullopt;
    }
    const Analysis analysis = solve_cases(file.path, *std::move(loaded));
    if (!choice.along) {
      add_findings(analysis, file.found);
    }
    const auto answer = find_tolerance(analysis, choice, file.found);
    return answer ? std::optional(make_tolerance_report(
                        file.path, analysis.description, *answer, file.forms, file.found))
                  : std::nullopt;
  });
}

}  // namespace kinestat
