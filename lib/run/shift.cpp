#include "run/shift.hpp"

#include <optional>
#include <utility>

#include "cases/exact_input_cases.hpp"
#include "cases/findings/case_findings.hpp"
#include "cases/findings/certainty_findings.hpp"
#include "cases/solve_cases.hpp"
#include "files/each_file.hpp"
#include "files/load_file.hpp"
#include "report/file/file_report.hpp"

namespace kinestat {

namespace {

// Leaves the gears, which come last.
void drop_own_cases(Loaded& loaded) {
  const auto gears = static_cast<std::ptrdiff_t>(loaded.shift->solution.table.steps.size());
  std::vector<Case>& cases = loaded.mechanism.cases;
  cases.erase(cases.begin(), cases.end() - gears);
  std::vector<CaseDescription>& described = loaded.description.cases;
  described.erase(described.begin(), described.end() - gears);
}

// Empty iff an error was added.
std::optional<CertifiedAnalysis> find_shift(const std::string& path,
                                            const ShiftChoice& choice,
                                            const AnalyseOptions& options,
                                            SourceFile& source,
                                            Diagnostics& found) {
  const ShiftOptions sizes{.one_more = choice.one_more, .one_fewer = choice.one_fewer};
  std::optional<Loaded> loaded = load(path, options.load, source, found, sizes);
  if (!loaded) {
    return std::nullopt;
  }
  if (!loaded->shift) {
    found.error("E0303",
                {},
                "the file has no section 'shift'",
                "add shift: {input: …, output: …, elements: […]}; 'kinestat new shift' writes a "
                "file that has one");
    return std::nullopt;
  }
  drop_own_cases(*loaded);
  check_exact_input(loaded->description, loaded->mechanism, options.accuracy, found);
  if (found.has_errors()) {
    return std::nullopt;
  }
  return solve_certified_cases(path, *std::move(loaded), options.accuracy);
}

}  // namespace

Outcome shift_of_files(const std::vector<std::string>& paths,
                       const ShiftChoice& choice,
                       const AnalyseOptions& options) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    const auto certified = find_shift(file.path, choice, options, file.source, file.found);
    if (!certified) {
      return std::nullopt;
    }
    add_certainty_findings(certified->analysis, certified->certainty, file.found);
    add_findings(certified->analysis, file.found);
    return make_shift_report(certified->analysis, file.forms, file.found);
  });
}

}  // namespace kinestat
