#include "run/motion.hpp"

#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "files/each_file.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "report/file/file_report.hpp"
#include "studies/motion/task/find_motion.hpp"

namespace kinestat {

namespace {

// Empty iff an error was added and there is nothing to report.
std::optional<MotionAnalysis> analyse_motion(const std::string& path,
                                             const MotionChoice& choice,
                                             const AnalyseOptions& options,
                                             SourceFile& source,
                                             Diagnostics& found) {
  std::optional<MechanismDescription> description =
      load_description(path, options.load, source, found);
  if (!description || !apply(choice, *description, found)) {
    return std::nullopt;
  }
  const std::optional<Mechanism> mechanism = bind_unassembled(*description, found);
  if (!mechanism) {
    if (!found.has_errors()) {
      refuse_without_mechanism(*description, found);
    }
    return std::nullopt;
  }
  std::optional<FoundMotion> motion = find_motion(*description, *mechanism, found);
  if (!motion) {
    return std::nullopt;
  }
  return MotionAnalysis{
      .file = path, .description = *std::move(description), .motion = std::move(motion->table)};
}

bool write_motion(const FileReport& report,
                  const std::string& path,
                  const OutputOptions& options,
                  InputPaths inputs,
                  Diagnostics& found) {
  const std::string stem = fmt::format("{}/{}.motion", options.folder, report_stem(path));
  const std::vector<OutputFile> files = {
      {.path = stem + ".json", .content = report.json, .signature = std::string(json_signature())},
      {.path = stem + ".csv",
       .content = laid_out(report.csv.front().text, options.layout),
       .signature = std::string(csv_signature())}};
  return write_files(files, options.overwrite, inputs, found);
}

}  // namespace

std::vector<std::string> motion_words() {
  const std::span<const std::string> words = motion_report_words();
  return {words.begin(), words.end()};
}

Outcome motion_of_files(const std::vector<std::string>& paths,
                        const MotionChoice& choice,
                        const AnalyseOptions& options) {
  ReportForms forms = options.is_quiet ? ReportForms{} : stream_forms(options.format, paths.size());
  if (!options.output.folder.empty()) {
    forms.json = true;
    forms.csv = true;
  }
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    SourceFile source;
    Diagnostics found;
    if (const auto analysis = analyse_motion(path, choice, options, source, found)) {
      const FileReport report = make_motion_report(*analysis, forms, found);
      add_to_stream(report, path, paths, options, outcome);
      if (!options.output.folder.empty()) {
        write_motion(report, path, options.output, input_paths(paths, options.load), found);
      }
    }
    add_diagnostics(source, found, options.strictness, outcome);
  });
}

}  // namespace kinestat
