#include "studies/inputs/report/inputs_report.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "mechanism/label_kind.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "studies/inputs/report/inputs_record.hpp"

namespace kinestat {

namespace {

std::vector<std::string> names_of(const std::vector<int>& magnitudes, const InputSide& side) {
  std::vector<std::string> names;
  for (const int m : magnitudes) {
    names.push_back(side.names[static_cast<std::size_t>(m)]);
  }
  return names;
}

QuantityKind kind_of(const TensioningDrive& drive) {
  return action_kind(drive.is_couple);
}

// For one unit of force in each segment.
double action_of(const TensioningDrive& drive, const FileUnits& units) {
  return drive.action * units.factor(QuantityKind::force) / units.factor(kind_of(drive));
}

const std::string& name_of(const TensioningDrive& drive, const InputsAnalysis& inputs) {
  return inputs.sides.front().names[static_cast<std::size_t>(drive.freedom)];
}

std::string count_text(std::uint64_t count, bool is_complete) {
  return (is_complete ? "" : "at least ") + counted(count, "set");
}

TextBlocks group_blocks(const InputGroup& group, const InputSide& side, bool is_alone) {
  TextBlocks text;
  if (!is_alone) {
    text += fmt::format("  {} of {}, whatever the others are: {}\n",
                        group.needed,
                        plain_list(names_of(group.magnitudes, side)),
                        count_text(group.count, group.is_complete));
  }
  if (group.best.empty()) {
    return text;
  }
  Table table({"Set", "conditioning"});
  for (const InputSet& set : group.best) {
    table.add({fmt::format("{}", fmt::join(names_of(set.magnitudes, side), ", ")),
               format_short(set.conditioning)});
  }
  text += TextBlocks(std::move(table), "  ");
  if (group.count > group.best.size()) {
    text += fmt::format("  … and {} more\n", group.count - group.best.size());
  }
  return text;
}

TextBlocks side_blocks(const InputSide& side) {
  const InputSets& sets = side.sets;
  TextBlocks text(fmt::format("{}: {} of {} determine{} the others; {}\n",
                              side.key == "motion" ? "Motions" : "Actions",
                              sets.needed,
                              side.names.size(),
                              sets.needed == 1 ? "s" : "",
                              count_text(sets.count(), sets.is_complete())));
  if (!sets.always_zero.empty()) {
    text += fmt::format("  always 0: {}\n", plain_list(names_of(sets.always_zero, side)));
  }
  for (const InputGroup& group : sets.groups) {
    text += group_blocks(group, side, sets.groups.size() == 1);
  }
  return text += "\n";
}

std::string choice_text(const ChoiceVerdict& choice) {
  const std::string names = fmt::format("{}", fmt::join(choice.names, ", "));
  if (choice.is_valid) {
    return fmt::format("{}: valid, conditioning {}\n", names, format_short(choice.conditioning));
  }
  return fmt::format("{}: not valid: {}\n{}",
                     names,
                     choice.reason,
                     choice.hint.empty() ? "" : fmt::format("  {}\n", choice.hint));
}

// How many actuators, and which pull against each other.
std::string cables_text(const InputsAnalysis& inputs, const FileUnits& units) {
  const CableTension& cables = *inputs.cables;
  std::string text = fmt::format("Cables: {}; {}{}\n",
                                 counted(cables.segments, "segment"),
                                 counted(cables.net_freedom, "freedom"),
                                 cables.without_slip == cables.net_freedom
                                     ? ""
                                     : fmt::format(", {} if none slips", cables.without_slip));
  if (!cables.is_possible) {
    return text + "  no actuators pull on every segment: loads must keep them in tension\n\n";
  }
  if (cables.drives.empty()) {
    return text +
           fmt::format(
               "  a pretension of their own keeps every segment in tension: {} suffice{}\n\n",
               counted(cables.actuators, "actuator"),
               cables.actuators == 1 ? "s" : "");
  }
  std::vector<std::string> drives;
  for (const TensioningDrive& drive : cables.drives) {
    drives.push_back(fmt::format("{} {} {}",
                                 name_of(drive, inputs),
                                 format_short(action_of(drive, units)),
                                 units.text(kind_of(drive))));
  }
  return text +
         fmt::format(
             "  {}{}, {} more than the freedoms, move it and keep every segment in tension:\n"
             "  {} pull at least 1 {} in each\n\n",
             cables.is_least() ? "" : "at most ",
             counted(cables.actuators, "actuator"),
             cables.actuators - cables.net_freedom,
             plain_list(drives),
             units.text(QuantityKind::force));
}

}  // namespace

FileReport make_inputs_report(const std::string& file,
                              const MechanismDescription& description,
                              const InputsAnalysis& inputs,
                              const ReportForms& forms,
                              const Diagnostics& found) {
  FileReport report;
  const InputsReportView view{
      .file = file, .description = description, .inputs = inputs, .found = &found};
  add_forms(inputs_report_record, view, forms, report);
  if (forms.text) {
    report.text += (description.name.empty() ? file : description.name) + "\n\n";
    for (const InputSide& side : inputs.sides) {
      report.text += side_blocks(side);
    }
    if (inputs.cables) {
      report.text += cables_text(inputs, description.units);
    }
    for (const ChoiceVerdict& choice : inputs.choices) {
      report.text += choice_text(choice);
    }
  }
  return report;
}

}  // namespace kinestat
