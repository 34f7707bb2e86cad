#include "run/internal/linkage_files.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/mechanism_writer.hpp"
#include "run/internal/linkage_description.hpp"

namespace kinestat {

namespace {

// A file that begins so is one of this program's own and may be replaced by another.
const std::vector<std::string> kSignature = {
    "yaml-language-server: $schema=mechanism.schema.json",
    "Written by 'kinestat synthesize', which replaces this file until this line is removed."};

std::string signature_text() {
  std::string text;
  for (const std::string& line : kSignature) {
    text += fmt::format("# {}\n", line);
  }
  return text;
}

std::string name_of(const SynthesisAnalysis& analysis, std::size_t task, std::size_t linkage) {
  const std::string stem = report_stem(analysis.file);
  return analysis.selection || analysis.tasks.size() > 1
             ? fmt::format("{}.task_{}.linkage_{}.yaml", stem, task, linkage)
             : fmt::format("{}.linkage_{}.yaml", stem, linkage);
}

std::string text_of(const SynthesisAnalysis& analysis,
                    const SynthesisTask& task,
                    std::size_t number) {
  std::vector<std::string> head = kSignature;
  for (std::string& line : linkage_comment(analysis, task, number)) {
    head.push_back(std::move(line));
  }
  MechanismDescription mechanism = describe_linkage(analysis, task, task.linkages[number]);
  mechanism.name += fmt::format(" {}", number);
  return mechanism_text(mechanism, head);
}

}  // namespace

bool write_linkages(SynthesisAnalysis& analysis,
                    WrittenLinkages which,
                    const OutputOptions& output,
                    Diagnostics& found) {
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i < analysis.tasks.size(); ++i) {
    SynthesisTask& task = analysis.tasks[i];
    task.files.resize(task.linkages.size());
    for (std::size_t j = 0; j < task.linkages.size(); ++j) {
      if (which == WrittenLinkages::usable && task.linkages[j].defect != Defect::none) {
        continue;
      }
      task.files[j] = fmt::format("{}/{}", output.folder, name_of(analysis, i, j));
      files.push_back({.path = task.files[j],
                       .content = text_of(analysis, task, j),
                       .signature = signature_text()});
    }
  }
  if (write_files(files, output.overwrite, found)) {
    return true;
  }
  for (SynthesisTask& task : analysis.tasks) {
    task.files.clear();
  }
  return false;
}

}  // namespace kinestat
