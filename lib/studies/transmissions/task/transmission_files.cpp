#include "studies/transmissions/task/transmission_files.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "format/mechanism_writer.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// A file that begins so is one of this program's own and may be replaced by another.
const std::vector<std::string> kTransmissionSignature = {
    "yaml-language-server: $schema=mechanism.schema.json",
    "Written by 'kinestat synthesize', which replaces this file until this line is removed."};

std::string transmission_signature() {
  std::string text;
  for (const std::string& line : kTransmissionSignature) {
    text += fmt::format("# {}\n", line);
  }
  return text;
}

// Which one it is, and where its teeth leave the stationary ratios of the search.
std::vector<std::string> transmission_comment(const TransmissionAnalysis& analysis,
                                              std::size_t ladder,
                                              std::size_t number) {
  const TransmissionVariant& variant = analysis.groups[ladder].variants[number];
  std::vector<std::string> lines = {fmt::format("Transmission {} of ladder {} of {}, structure {}.",
                                                number,
                                                ladder,
                                                analysis.file,
                                                variant.found.structure)};
  for (std::size_t s = 0; s < variant.teeth.size(); ++s) {
    const double wanted = variant.found.stationary_ratios[s];
    const double has = variant.teeth[s].stationary_ratio();
    if (has != wanted) {
      lines.push_back(fmt::format("Set {}: {} teeth by {} are {}, the search has {}.",
                                  s + 1,
                                  variant.teeth[s].ring,
                                  variant.teeth[s].sun,
                                  format_short(has),
                                  format_short(wanted)));
    }
  }
  lines.push_back("The table of its gears: kinestat shift FILE");
  return lines;
}

std::string transmission_text(const TransmissionAnalysis& analysis,
                              std::size_t ladder,
                              std::size_t number) {
  std::vector<std::string> head = kTransmissionSignature;
  for (std::string& line : transmission_comment(analysis, ladder, number)) {
    head.push_back(std::move(line));
  }
  MechanismDescription mechanism =
      describe_transmission(analysis, analysis.groups[ladder].variants[number]);
  mechanism.name += fmt::format(" {}.{}", ladder, number);
  return mechanism_text(mechanism, head);
}

}  // namespace

bool write_transmissions(TransmissionAnalysis& analysis,
                         const OutputOptions& output,
                         InputPaths inputs,
                         Diagnostics& found) {
  std::vector<OutputFile> files;
  for (std::size_t g = 0; g < analysis.groups.size(); ++g) {
    std::vector<TransmissionVariant>& variants = analysis.groups[g].variants;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      variants[i].file = fmt::format(
          "{}/{}.ladder_{}.transmission_{}.yaml", output.folder, report_stem(analysis.file), g, i);
      files.push_back({.path = variants[i].file,
                       .content = transmission_text(analysis, g, i),
                       .signature = transmission_signature()});
    }
  }
  if (write_files(files, output.overwrite, inputs, found)) {
    return true;
  }
  for (LadderGroup& group : analysis.groups) {
    for (TransmissionVariant& variant : group.variants) {
      variant.file.clear();
    }
  }
  return false;
}

}  // namespace kinestat
