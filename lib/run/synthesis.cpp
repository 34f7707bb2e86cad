#include "run/synthesis.hpp"

#include <optional>
#include <utility>

#include "files/each_file.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"
#include "studies/synthesis/task/linkage_files.hpp"
#include "studies/transmissions/task/find_transmissions.hpp"

namespace kinestat {

namespace {

std::optional<FileReport> report_on_transmissions(ReportedFile& file,
                                                  MechanismDescription description,
                                                  const AnalyseOptions& options,
                                                  const TransmissionOptions& transmissions) {
  if (!options.output.folder.empty()) {
    file.found.error("E0303",
                     description.synthesis->transmission->where,
                     "--write-mechanism writes linkages, and the task is one of transmissions",
                     "leave it out; --format json has sets, shafts and elements of each");
    return std::nullopt;
  }
  const auto analysis =
      find_transmissions(file.path, std::move(description), transmissions, file.found);
  return analysis ? std::optional(make_transmission_report(*analysis, file.forms, file.found))
                  : std::nullopt;
}

}  // namespace

Outcome synthesize_files(const std::vector<std::string>& paths,
                         const AnalyseOptions& options,
                         const SynthesisOptions& synthesis,
                         const TransmissionOptions& transmissions) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    auto description = load_description(file.path, options.load, file.source, file.found);
    if (description && description->synthesis && description->synthesis->transmission) {
      return report_on_transmissions(file, *std::move(description), options, transmissions);
    }
    auto analysis = description
                        ? find_synthesis(file.path, *std::move(description), synthesis, file.found)
                        : std::nullopt;
    if (!analysis) {
      return std::nullopt;
    }
    if (synthesis.verifies || !options.output.folder.empty()) {
      check_linkages(*analysis, synthesis, file.found);
    }
    if (!options.output.folder.empty()) {
      write_linkages(*analysis, synthesis.written, options.output, file.found);
    }
    return make_synthesis_report(*analysis, file.forms, file.found);
  });
}

}  // namespace kinestat
