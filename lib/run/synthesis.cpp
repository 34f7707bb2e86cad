#include "run/synthesis.hpp"

#include <optional>
#include <utility>

#include "files/each_file.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"
#include "studies/synthesis/task/linkage_files.hpp"

namespace kinestat {

Outcome synthesize_files(const std::vector<std::string>& paths,
                         const AnalyseOptions& options,
                         const SynthesisOptions& synthesis) {
  return report_on_each_file(paths, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    auto description = load_description(file.path, options.load, file.source, file.found);
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
