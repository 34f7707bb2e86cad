#include <fmt/format.h>

#include "core/text.hpp"
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
  text += fmt::format("\n{}, {}",
                      counted(stages.found, "transmission") + " found",
                      counted(analysis.ladder_count, "ladder"));
  text += analysis.groups.size() < analysis.ladder_count
              ? fmt::format(", the best {} listed\n", analysis.groups.size())
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

// A simple set and one with planets in pairs on one carrier and in one ring: ", 1 and 2 as a
// Ravigneaux set".
std::string ravigneaux_text(const TransmissionVariant& variant) {
  const auto shafts = [&](std::size_t s, std::uint8_t SetRoles::*role) {
    return variant.sets[s][set_roles(variant.found.roles.roles_of(static_cast<int>(s))).*role];
  };
  std::string text;
  for (std::size_t a = 0; a < variant.sets.size(); ++a) {
    for (std::size_t b = a + 1; b < variant.sets.size(); ++b) {
      const bool are_one = shafts(a, &SetRoles::carrier) == shafts(b, &SetRoles::carrier) &&
                           shafts(a, &SetRoles::ring) == shafts(b, &SetRoles::ring);
      if (are_one && variant.found.roles.kind_of(static_cast<int>(a)) !=
                         variant.found.roles.kind_of(static_cast<int>(b))) {
        text += fmt::format(", {} and {} as a Ravigneaux set", a + 1, b + 1);
      }
    }
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
    const LadderGear& gear = variant.gears[i];
    const bool has_step = i > 0 && gear.figures.ratio > 0.0;
    columns[0].cells.push_back(gear.label);
    columns[1].cells.push_back(engaged_letters(gear.engaged));
    columns[2].cells.push_back(format_short(gear.figures.ratio));
    columns[3].cells.push_back(
        has_step ? format_short(variant.gears[i - 1].figures.ratio / gear.figures.ratio) : "");
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

std::string figures_text(const LadderFigures& figures) {
  return fmt::format(
      "  spread {}, mean efficiency of the forward gears {}; {}{}\n"
      "  up to: torque of an element {}, slip {}, speed of a shaft {}, of a planet in its carrier "
      "{}\n",
      format_short(figures.spread),
      format_short(figures.mean_efficiency),
      counted(figures.rotating_clutches, "rotating clutch", "rotating clutches"),
      figures.hollow_shafts ? ", " + counted(*figures.hollow_shafts, "hollow shaft") : "",
      format_short(figures.element_torque),
      format_short(figures.element_slip),
      format_short(figures.shaft_speed),
      format_short(figures.planet_speed));
}

}  // namespace

std::string transmission_sentence(const TransmissionAnalysis& analysis) {
  if (analysis.groups.empty()) {
    return "No transmission meets the requirements.";
  }
  std::vector<std::string> ratios;
  const TransmissionVariant& best = analysis.groups.front().variants.front();
  for (const LadderGear& gear : best.gears) {
    ratios.push_back(format_short(gear.figures.ratio));
  }
  return fmt::format("{} of {} found; the best: {}, mean efficiency of the forward gears {}.",
                     counted(analysis.stages.found, "transmission"),
                     counted(analysis.ladder_count, "ladder"),
                     plain_list(ratios),
                     format_short(best.found.figures.mean_efficiency));
}

TextBlocks transmission_blocks(const TransmissionAnalysis& analysis) {
  TextBlocks text(stages_text(analysis));
  if (!analysis.groups.empty()) {
    text +=
        "Torques of engaged elements and, in brackets, slips of open ones by those of the input.\n";
  }
  for (std::size_t g = 0; g < analysis.groups.size(); ++g) {
    const std::vector<TransmissionVariant>& variants = analysis.groups[g].variants;
    text += fmt::format("\nLadder {}, {}\n", g, counted(variants.size(), "transmission"));
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const TransmissionVariant& one = variants[i];
      text += fmt::format(
          "  {}.{}  structure {}, stationary ratios {}\n"
          "       shafts: {}\n"
          "       elements: {}\n",
          g,
          i,
          one.found.structure,
          sets_text(one) + ravigneaux_text(one),
          connections_text(one),
          elements_text(one));
    }
    text += gears_table(variants.front());
    text += figures_text(variants.front().found.figures);
  }
  return text;
}

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
    report.text = TextBlocks(title_text(analysis.file, analysis.description));
    report.text += transmission_blocks(analysis);
  }
  return report;
}

}  // namespace kinestat
