#include "studies/synthesis/task/linkage_files.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "format/mechanism_writer.hpp"

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

// Adds the files of one task and notes their paths in it.
void add_files(SynthesisAnalysis& analysis,
               std::size_t number,
               WrittenLinkages which,
               const std::string& folder,
               std::vector<OutputFile>& files) {
  SynthesisTask& task = analysis.tasks[number];
  task.files.resize(task.linkages.size());
  for (std::size_t i = 0; i < task.linkages.size(); ++i) {
    if (which == WrittenLinkages::all || task.linkages[i].is_usable()) {
      task.files[i] = fmt::format("{}/{}", folder, name_of(analysis, number, i));
      files.push_back({.path = task.files[i],
                       .content = text_of(analysis, task, i),
                       .signature = signature_text()});
    }
  }
}

}  // namespace

bool write_linkages(SynthesisAnalysis& analysis,
                    WrittenLinkages which,
                    const OutputOptions& output,
                    InputPaths inputs,
                    Diagnostics& found) {
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i < analysis.tasks.size(); ++i) {
    add_files(analysis, i, which, output.folder, files);
  }
  if (write_files(files, output.overwrite, inputs, found)) {
    return true;
  }
  for (SynthesisTask& task : analysis.tasks) {
    task.files.clear();
  }
  return false;
}

}  // namespace kinestat
