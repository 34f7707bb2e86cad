#include "run/simulation.hpp"

#include <optional>

#include "files/each_file.hpp"
#include "files/load_file.hpp"
#include "studies/simulation/report/simulation_report.hpp"

namespace kinestat {

SimulationReportView simulation_view(const std::string& path,
                                     const MechanismDescription& description,
                                     const FoundSimulation& answer,
                                     const Diagnostics* found) {
  return {.file = path,
          .description = description,
          .mechanism = answer.mechanism,
          .plan = answer.plan,
          .solution = answer.solution,
          .found = found};
}

Outcome simulate_files(const std::vector<std::string>& paths,
                       const std::vector<std::string>& report,
                       const AnalyseOptions& options) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    std::optional<MechanismDescription> description =
        load_description(file.path, options.load, file.source, file.found);
    if (!description) {
      return std::nullopt;
    }
    if (description->simulation && !report.empty()) {
      std::vector<Name>& named = description->simulation->report;
      named.clear();
      for (const std::string& one : report) {
        named.push_back({.text = one, .where = {}});
      }
    }
    const std::optional<FoundSimulation> answer = find_simulation(*description, file.found);
    if (!answer) {
      return std::nullopt;
    }
    return make_simulation_report(simulation_view(file.path, *description, *answer, &file.found),
                                  file.forms);
  });
}

}  // namespace kinestat
