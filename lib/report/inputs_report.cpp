#include "report/inputs_report.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "network/evidence_record.hpp"
#include "report/table_archive.hpp"
#include "report/report_parts.hpp"
#include "report/csv.hpp"
#include "report/numbers.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

std::vector<std::string> names_of(const std::vector<int>& magnitudes, const InputSide& side) {
  std::vector<std::string> names;
  for (const int m : magnitudes) {
    names.push_back(side.names[static_cast<std::size_t>(m)]);
  }
  return names;
}

Json group_json(const InputGroup& group, const InputSide& side) {
  Json result = object_of(8);
  result["needed"] = group.needed;
  result["magnitudes"] = names_of(group.magnitudes, side);
  result["count"] = group.count;
  result["complete"] = group.is_complete;
  result["sets"] = Json::array();
  for (const InputSet& set : group.best) {
    Json one = object_of(2);
    one["magnitudes"] = names_of(set.magnitudes, side);
    one["conditioning"] = number(set.conditioning);
    result["sets"].push_back(std::move(one));
  }
  return result;
}

Json side_json(const InputSide& side) {
  Json result = object_of(8);
  result["needed"] = side.sets.needed;
  result["always_zero"] = names_of(side.sets.always_zero, side);
  result["count"] = side.sets.count();
  result["complete"] = side.sets.is_complete();
  result["groups"] = Json::array();
  for (const InputGroup& group : side.sets.groups) {
    result["groups"].push_back(group_json(group, side));
  }
  result["evidence"] = json_of(rank_evidence_record(), side.evidence, FileUnits());
  return result;
}

Json choice_json(const ChoiceVerdict& choice) {
  Json result = object_of(8);
  result["side"] = choice.key;
  result["magnitudes"] = choice.names;
  result["valid"] = choice.is_valid;
  if (choice.is_valid) {
    result["conditioning"] = number(choice.conditioning);
  } else {
    result["reason"] = choice.reason;
    result["hint"] = choice.hint;
  }
  return result;
}

QuantityKind kind_of(const TautDrive& drive) {
  return drive.is_couple ? QuantityKind::moment : QuantityKind::force;
}

// For one unit of force in each segment.
double action_of(const TautDrive& drive, const FileUnits& units) {
  return drive.action * units.factor(QuantityKind::force) / units.factor(kind_of(drive));
}

const std::string& name_of(const TautDrive& drive, const InputsAnalysis& inputs) {
  return inputs.sides.front().names[static_cast<std::size_t>(drive.freedom)];
}

Json ropes_json(const InputsAnalysis& inputs, const FileUnits& units) {
  const TautRopes& ropes = *inputs.ropes;
  Json result = object_of(8);
  result["segments"] = ropes.segments;
  result["net_freedom"] = ropes.net_freedom;
  result["without_slip"] = ropes.without_slip;
  result["possible"] = ropes.is_possible;
  result["actuators"] = ropes.is_possible ? Json(ropes.actuators) : Json(nullptr);
  result["least"] = ropes.is_possible && ropes.is_least();
  result["drives"] = object_of(ropes.drives.size());
  for (const TautDrive& drive : ropes.drives) {
    result["drives"][name_of(drive, inputs)] = number(action_of(drive, units));
  }
  return result;
}

// The set is the element, its names joined by blanks.
std::string csv_of(const MechanismDescription& description, const InputsAnalysis& inputs) {
  std::string text(kCsvHeader);
  const auto add_with_unit = [&](const std::string& element,
                                 const std::string& quantity,
                                 const std::string& value,
                                 const std::string& unit,
                                 const std::string& status) {
    text += csv_line(std::array<std::string, 8>{
        description.name, "", "inputs", element, quantity, value, unit, status});
  };
  const auto add = [&](const std::string& element,
                       const std::string& quantity,
                       const std::string& value,
                       const std::string& status) {
    add_with_unit(element, quantity, value, "", status);
  };
  for (const InputSide& side : inputs.sides) {
    add("", side.key + "/needed", std::to_string(side.sets.needed), "solved");
    add("",
        side.key + "/count",
        std::to_string(side.sets.count()),
        side.sets.is_complete() ? "solved" : "at least");
    for (const InputGroup& group : side.sets.groups) {
      for (const InputSet& set : group.best) {
        add(fmt::format("{}", fmt::join(names_of(set.magnitudes, side), " ")),
            side.key + "/conditioning",
            format_exact(set.conditioning),
            "solved");
      }
    }
  }
  if (inputs.ropes) {
    const TautRopes& ropes = *inputs.ropes;
    add("", "ropes/segments", std::to_string(ropes.segments), "solved");
    add("", "ropes/net_freedom", std::to_string(ropes.net_freedom), "solved");
    add("", "ropes/without_slip", std::to_string(ropes.without_slip), "solved");
    add("",
        "ropes/actuators",
        ropes.is_possible ? std::to_string(ropes.actuators) : "",
        !ropes.is_possible ? "none"
        : ropes.is_least() ? "solved"
                           : "at most");
    for (const TautDrive& drive : ropes.drives) {
      add_with_unit(name_of(drive, inputs),
                    "ropes/drives",
                    format_exact(action_of(drive, description.units)),
                    description.units.text(kind_of(drive)),
                    "solved");
    }
  }
  for (const ChoiceVerdict& choice : inputs.choices) {
    add(fmt::format("{}", fmt::join(choice.names, " ")),
        choice.key + "/conditioning",
        choice.is_valid ? format_exact(choice.conditioning) : "",
        choice.is_valid ? "chosen" : "not valid");
  }
  return text;
}

std::string count_text(std::uint64_t count, bool is_complete) {
  return fmt::format("{}{} set{}", is_complete ? "" : "at least ", count, count == 1 ? "" : "s");
}

std::string group_text(const InputGroup& group, const InputSide& side, bool is_alone) {
  std::string text;
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
  text += table.text("  ");
  if (group.count > group.best.size()) {
    text += fmt::format("  … and {} more\n", group.count - group.best.size());
  }
  return text;
}

std::string side_text(const InputSide& side) {
  const InputSets& sets = side.sets;
  std::string text = fmt::format("{}: {} of {} determine{} the others; {}\n",
                                 side.key == "motion" ? "Motions" : "Actions",
                                 sets.needed,
                                 side.names.size(),
                                 sets.needed == 1 ? "s" : "",
                                 count_text(sets.count(), sets.is_complete()));
  if (!sets.always_zero.empty()) {
    text += fmt::format("  always 0: {}\n", plain_list(names_of(sets.always_zero, side)));
  }
  for (const InputGroup& group : sets.groups) {
    text += group_text(group, side, sets.groups.size() == 1);
  }
  return text + "\n";
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
std::string ropes_text(const InputsAnalysis& inputs, const FileUnits& units) {
  const TautRopes& ropes = *inputs.ropes;
  const auto count = [](int number, const char* what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  std::string text = fmt::format("Ropes: {}; {}{}\n",
                                 count(ropes.segments, "segment"),
                                 count(ropes.net_freedom, "freedom"),
                                 ropes.without_slip == ropes.net_freedom
                                     ? ""
                                     : fmt::format(", {} if none slips", ropes.without_slip));
  if (!ropes.is_possible) {
    return text + "  no actuators pull on every segment: loads must keep them taut\n\n";
  }
  if (ropes.drives.empty()) {
    return text +
           fmt::format("  a pretension of their own keeps every segment taut: {} suffice{}\n\n",
                       count(ropes.actuators, "actuator"),
                       ropes.actuators == 1 ? "s" : "");
  }
  std::vector<std::string> drives;
  for (const TautDrive& drive : ropes.drives) {
    drives.push_back(fmt::format("{} {} {}",
                                 name_of(drive, inputs),
                                 format_short(action_of(drive, units)),
                                 units.text(kind_of(drive))));
  }
  return text + fmt::format(
                    "  {}{}, {} more than the freedoms, move it and keep every segment taut:\n"
                    "  {} pull at least 1 {} in each\n\n",
                    ropes.is_least() ? "" : "at most ",
                    count(ropes.actuators, "actuator"),
                    ropes.actuators - ropes.net_freedom,
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
  if (forms.json || forms.json_line) {
    Json json = report_head(file, description);
    json["inputs"] = object_of(inputs.sides.size() + 1);
    for (const InputSide& side : inputs.sides) {
      json["inputs"][side.key] = side_json(side);
    }
    if (inputs.ropes) {
      json["inputs"]["ropes"] = ropes_json(inputs, description.units);
    }
    json["choices"] = Json::array();
    for (const ChoiceVerdict& choice : inputs.choices) {
      json["choices"].push_back(choice_json(choice));
    }
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
  }
  if (forms.csv) {
    report.csv.push_back({.pass = "inputs", .text = csv_of(description, inputs)});
  }
  if (forms.text) {
    report.text = (description.name.empty() ? file : description.name) + "\n\n";
    for (const InputSide& side : inputs.sides) {
      report.text += side_text(side);
    }
    if (inputs.ropes) {
      report.text += ropes_text(inputs, description.units);
    }
    for (const ChoiceVerdict& choice : inputs.choices) {
      report.text += choice_text(choice);
    }
  }
  return report;
}

}  // namespace kinestat
