#include "run/synthesis.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "files/each_file.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"
#include "studies/synthesis/task/linkage_files.hpp"
#include "studies/transmissions/task/find_transmissions.hpp"
#include "studies/transmissions/task/transmission_files.hpp"

namespace kinestat {

namespace {

std::optional<FileReport> report_on_transmissions(ReportedFile& file,
                                                  InputPaths inputs,
                                                  MechanismDescription description,
                                                  const AnalyseOptions& options,
                                                  const SynthesisOptions& synthesis,
                                                  const TransmissionOptions& transmissions) {
  if (synthesis.digits || synthesis.written == WrittenLinkages::all) {
    file.found.error("E0101",
                     description.synthesis->transmission->where,
                     fmt::format("{} is of linkages, and the task is one of transmissions",
                                 synthesis.digits ? "--digits" : "--all-linkages"),
                     "leave it out");
    return std::nullopt;
  }
  auto analysis = find_transmissions(file.path, std::move(description), transmissions, file.found);
  if (!analysis) {
    return std::nullopt;
  }
  if (synthesis.verifies || !options.output.folder.empty()) {
    check_transmissions(*analysis, file.found);
  }
  if (!options.output.folder.empty()) {
    write_transmissions(*analysis, options.output, inputs, file.found);
  }
  return make_transmission_report(*analysis, file.forms, file.found);
}

// False with an error where an option is of transmissions alone.
bool check_for_linkages(const SourceRange& where,
                        const TransmissionOptions& transmissions,
                        Diagnostics& found) {
  const char* const option = transmissions.top            ? "--top"
                             : transmissions.rank         ? "--by"
                             : transmissions.share        ? "--shard"
                             : transmissions.work.empty() ? nullptr
                                                          : "--work";
  if (option != nullptr) {
    found.error("E0101",
                where,
                fmt::format("{} is of transmissions, and the task is one of linkages", option),
                "leave it out; linkages are all listed, the best first");
  }
  return option == nullptr;
}

}  // namespace

Outcome synthesize_files(const std::vector<std::string>& paths,
                         const AnalyseOptions& options,
                         const SynthesisOptions& synthesis,
                         const TransmissionOptions& transmissions) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    auto description = load_description(file.path, options.load, file.source, file.found);
    if (description && description->synthesis && description->synthesis->transmission) {
      return report_on_transmissions(
          file, paths, *std::move(description), options, synthesis, transmissions);
    }
    if (description && description->synthesis &&
        !check_for_linkages(description->synthesis->where, transmissions, file.found)) {
      return std::nullopt;
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
      write_linkages(*analysis, synthesis.written, options.output, paths, file.found);
    }
    return make_synthesis_report(*analysis, file.forms, file.found);
  });
}

}  // namespace kinestat
