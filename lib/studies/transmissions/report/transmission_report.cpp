#include <fmt/format.h>

#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "studies/transmissions/report/transmission_record.hpp"

namespace kinestat {

namespace {

std::string stages_text(const TransmissionAnalysis& analysis) {
  const SearchStages& stages = analysis.stages;
  std::string text = fmt::format(
      "{} of {} structures, {} layouts of elements, {} with sun, carrier and ring of every set\n"
      "{} not refuted by ranges of ratios, {} with a ladder",
      stages.structures,
      analysis.structure_count,
      stages.layouts,
      stages.labelled_layouts,
      stages.not_refuted,
      stages.with_ladder);
  for (const auto& [count, what] : {std::pair(stages.not_buildable, "cannot be arranged"),
                                    std::pair(stages.over_limits, "exceed limits"),
                                    std::pair(stages.undecided, "others undecided")}) {
    text += count > 0 ? fmt::format(", {} {}", count, what) : "";
  }
  text += fmt::format("\n{} transmissions found, {} ladders", stages.found, analysis.ladder_count);
  text += analysis.groups.size() < analysis.ladder_count
              ? fmt::format(", of which {} are listed\n", analysis.groups.size())
              : "\n";
  return text;
}

// What is on each shaft: "x3 = S1 = S2".
std::string connections_text(const TransmissionVariant& variant) {
  std::string text;
  for (int i = 0; i < variant.shafts; ++i) {
    const auto shaft = static_cast<Shaft>(i);
    std::string one = shaft_name(shaft);
    for (std::size_t s = 0; s < variant.sets.size(); ++s) {
      const SetRoles roles = set_roles(variant.found.roles.roles_of(static_cast<int>(s)));
      for (const auto& [letter, place] :
           {std::pair('S', roles.sun), std::pair('C', roles.carrier), std::pair('R', roles.ring)}) {
        one += variant.sets[s][place] == shaft ? fmt::format(" = {}{}", letter, s + 1) : "";
      }
    }
    text += (i == 0 ? "" : ", ") + one;
  }
  return text;
}

std::string elements_text(const TransmissionVariant& variant) {
  std::string text;
  for (std::size_t j = 0; j < variant.found.elements.size(); ++j) {
    const ShaftPair& pair = variant.found.elements[j];
    text += fmt::format("{}{} {}-{}",
                        j == 0 ? "" : ", ",
                        element_letter(j),
                        shaft_name(pair[0]),
                        shaft_name(pair[1]));
  }
  return text;
}

std::string sets_text(const TransmissionVariant& variant) {
  std::string text;
  for (std::size_t s = 0; s < variant.sets.size(); ++s) {
    const bool is_simple = variant.found.roles.kind_of(static_cast<int>(s)) == SetKind::simple;
    text += fmt::format("{}{} {}{}",
                        s == 0 ? "" : ", ",
                        s + 1,
                        format_short(variant.found.stationary_ratios[s]),
                        is_simple ? "" : " (planets in pairs)");
  }
  return text;
}

TextBlocks gears_table(const TransmissionVariant& variant) {
  std::vector<TextColumn> columns = {
      {"Gear", {}}, {"engaged", {}}, {"ratio", {}}, {"step", {}}, {"efficiency", {}}};
  const std::size_t first = columns.size();
  for (std::size_t j = 0; j < variant.found.elements.size(); ++j) {
    columns.push_back({element_letter(j), {}});
  }
  for (std::size_t i = 0; i < variant.gears.size(); ++i) {
    const ListedGear& gear = variant.gears[i];
    const bool has_next = i + 1 < variant.gears.size() && variant.gears[i + 1].figures.ratio > 0.0;
    columns[0].cells.push_back(gear.label);
    columns[1].cells.push_back(engaged_letters(gear.engaged));
    columns[2].cells.push_back(format_short(gear.figures.ratio));
    columns[3].cells.push_back(
        has_next ? format_short(gear.figures.ratio / variant.gears[i + 1].figures.ratio) : "");
    columns[4].cells.push_back(format_short(gear.efficiency));
    for (std::size_t j = 0; j < variant.found.elements.size(); ++j) {
      const bool is_engaged = (gear.engaged >> j & 1U) != 0;
      columns[first + j].cells.push_back(
          is_engaged ? format_short(gear.figures.torques[j])
                     : fmt::format("({})", format_short(gear.figures.slips[j])));
    }
  }
  return TextBlocks(std::move(columns));
}

TextBlocks transmission_text(const TransmissionAnalysis& analysis) {
  TextBlocks text(title_text(analysis.file, analysis.description));
  text += stages_text(analysis);
  if (!analysis.groups.empty()) {
    text +=
        "Torques of engaged elements by that of the input; in brackets slips of open ones by\n"
        "its speed.\n";
  }
  for (std::size_t g = 0; g < analysis.groups.size(); ++g) {
    const std::vector<TransmissionVariant>& variants = analysis.groups[g].variants;
    text += fmt::format(
        "\nLadder {}, {} transmission{}\n", g, variants.size(), variants.size() == 1 ? "" : "s");
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const TransmissionVariant& one = variants[i];
      text += fmt::format(
          "  {}.{}  structure {}, stationary ratios {}\n"
          "       {}\n"
          "       {}\n",
          g,
          i,
          one.found.structure,
          sets_text(one),
          connections_text(one),
          elements_text(one));
    }
    text += gears_table(variants.front());
  }
  return text;
}

}  // namespace

std::string element_letter(std::size_t element) {
  return std::string(1, static_cast<char>('A' + element));
}

std::string engaged_letters(std::uint8_t engaged) {
  std::string letters;
  for (std::size_t j = 0; j < kMostElements; ++j) {
    letters += (engaged >> j & 1U) != 0 ? element_letter(j) : "";
  }
  return letters;
}

std::string shaft_name(Shaft shaft) {
  return shaft == kHousing  ? "housing"
         : shaft == kInput  ? "in"
         : shaft == kOutput ? "out"
                            : fmt::format("x{}", shaft);
}

FileReport make_transmission_report(const TransmissionAnalysis& analysis,
                                    const ReportForms& forms,
                                    const Diagnostics& found) {
  FileReport report;
  const TransmissionReportView view{.file = analysis.file,
                                    .description = analysis.description,
                                    .analysis = analysis,
                                    .found = &found};
  add_forms(transmission_report_record, view, forms, report);
  if (forms.text) {
    report.text = transmission_text(analysis);
  }
  return report;
}

}  // namespace kinestat
