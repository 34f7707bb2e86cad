#include "run/duty.hpp"

#include <optional>

#include "files/each_file.hpp"
#include "files/load_file.hpp"
#include "studies/duty/report/duty_report.hpp"
#include "studies/duty/task/find_duty.hpp"

namespace kinestat {

Outcome duty_of_files(const std::vector<std::string>& paths,
                      const std::string& table,
                      const AnalyseOptions& options) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    const std::optional<Loaded> loaded = load(file.path, options.load, file.source, file.found);
    if (!loaded) {
      return std::nullopt;
    }
    const JudgedFile judged{
        .description = loaded->description, .mechanism = loaded->mechanism, .shift = loaded->shift};
    const std::optional<FoundDuty> duty = find_duty(file.path, table, judged, file.found);
    if (!duty) {
      return std::nullopt;
    }
    return make_duty_report({.file = file.path,
                             .description = loaded->description,
                             .mechanism = loaded->mechanism,
                             .plan = duty->plan,
                             .duty = duty->solution,
                             .found = &file.found},
                            file.forms);
  });
}

}  // namespace kinestat
