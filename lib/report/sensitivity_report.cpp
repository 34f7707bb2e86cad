#include "report/sensitivity_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "report/table_archive.hpp"
#include "report/report_parts.hpp"
#include "report/csv.hpp"
#include "report/numbers.hpp"
#include "report/table.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

namespace {

using Parameters = std::vector<SensitivityParameter>;

// "rad/s per mm"; a bare parameter leaves the unit of the value.
std::string unit_of(const SensitivityValue& value, const SensitivityParameter& parameter) {
  if (parameter.unit.empty()) {
    return value.unit;
  }
  return fmt::format("{} per {}", value.unit.empty() ? "1" : value.unit, parameter.unit);
}

Json value_json(const SensitivityValue& value, const Parameters& parameters) {
  Json result = object_of(8);
  result["value"] = number(value.value);
  result["unit"] = value.unit;
  if (value.completed_by != IndeterminateChoice::report) {
    result["completion"] = word_of(value.completed_by);
  }
  result["by"] = object_of(parameters.size());
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    Json entry = object_of(8);
    entry["derivative"] = number(value.derivatives[p]);
    entry["unit"] = unit_of(value, parameters[p]);
    entry["relative"] = number(relative_sensitivity(value, parameters[p], value.derivatives[p]));
    result["by"][parameters[p].name] = std::move(entry);
  }
  return result;
}

// As the CSV of the analysis has it.
std::string status_of(const SensitivityValue& value) {
  return value.completed_by == IndeterminateChoice::report
             ? "solved"
             : std::string(word_of(value.completed_by));
}

std::string csv_of(const std::string& mechanism,
                   const std::vector<CaseSensitivity>& cases,
                   const Parameters& parameters) {
  std::string text(kCsvHeader);
  const auto exact = [](std::optional<double> value) {
    return value ? format_exact(*value) : std::string();
  };
  for (const CaseSensitivity& one : cases) {
    for (const SensitivityValue& value : one.values) {
      for (std::size_t p = 0; p < parameters.size(); ++p) {
        const auto derivative = value.derivatives[p];
        const auto relative = relative_sensitivity(value, parameters[p], derivative);
        const std::string status = derivative ? status_of(value) : "no derivative";
        text += csv_line(std::array<std::string, 8>{mechanism,
                                                    one.label,
                                                    "sensitivity",
                                                    value.name,
                                                    "by/" + parameters[p].name + "/derivative",
                                                    exact(derivative),
                                                    unit_of(value, parameters[p]),
                                                    status});
        text += csv_line(std::array<std::string, 8>{mechanism,
                                                    one.label,
                                                    "sensitivity",
                                                    value.name,
                                                    "by/" + parameters[p].name + "/relative",
                                                    exact(relative),
                                                    "",
                                                    status});
      }
    }
  }
  return text;
}

// The strongest first; those without influence or derivative last, in the order of the file.
std::vector<std::size_t> by_strength(const SensitivityValue& value, const Parameters& parameters) {
  std::vector<std::size_t> order(parameters.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t p) {
    const auto relative = relative_sensitivity(value, parameters[p], value.derivatives[p]);
    return std::abs(relative.value_or(value.derivatives[p].value_or(0.0)));
  });
  return order;
}

Table table_of(const SensitivityValue& value, const Parameters& parameters) {
  Table table({"by", "at", "derivative", "unit", "relative"});
  for (const std::size_t p : by_strength(value, parameters)) {
    const SensitivityParameter& parameter = parameters[p];
    const auto derivative = value.derivatives[p];
    const auto relative = relative_sensitivity(value, parameter, derivative);
    const std::string at = format_short(parameter.value);
    table.add({parameter.name,
               parameter.unit.empty() ? at : at + " " + parameter.unit,
               derivative ? format_short(*derivative) : "none",
               unit_of(value, parameter),
               relative ? format_short(*relative) : "-"});
  }
  return table;
}

// Behind a value that equilibrium alone leaves open.
std::string_view note_of(const SensitivityValue& value) {
  switch (value.completed_by) {
    case IndeterminateChoice::report:
      return "";
    case IndeterminateChoice::minimum_norm:
      return "; a convention: least norm";
    case IndeterminateChoice::stiffness:
      return "; by the stiffness of couplings";
  }
  return "";
}

std::string text_of(const MechanismDescription& description,
                    const std::string& file,
                    const std::vector<CaseSensitivity>& cases,
                    const Parameters& parameters) {
  std::string text = (description.name.empty() ? file : description.name) + "\n\n";
  for (const CaseSensitivity& one : cases) {
    text += fmt::format("Case {}\n", one.label) + sensitivity_blocks(one, parameters).text();
  }
  return text;
}

}  // namespace

std::optional<double> relative_sensitivity(const SensitivityValue& value,
                                           const SensitivityParameter& parameter,
                                           std::optional<double> derivative) {
  if (!derivative || value.value == 0.0) {
    return std::nullopt;
  }
  const double relative = *derivative * parameter.value / value.value;
  return std::isfinite(relative) ? std::optional(relative) : std::nullopt;
}

TextBlocks sensitivity_blocks(const CaseSensitivity& one, const Parameters& parameters) {
  TextBlocks blocks;
  for (const SensitivityValue& value : one.values) {
    blocks += fmt::format("  {} = {}{}{}{}\n",
                          value.name,
                          format_short(value.value),
                          value.unit.empty() ? "" : " ",
                          value.unit,
                          note_of(value));
    blocks += TextBlocks(table_of(value, parameters), "    ");
    blocks += "\n";
  }
  return blocks;
}

FileReport make_sensitivity_report(const std::string& file,
                                   const MechanismDescription& description,
                                   const std::vector<SensitivityParameter>& parameters,
                                   const std::vector<CaseSensitivity>& cases,
                                   const ReportForms& forms,
                                   const Diagnostics& found) {
  FileReport report;
  if (forms.json || forms.json_line) {
    Json json = report_head(file, description);
    json["cases"] = object_of(8);
    for (const CaseSensitivity& one : cases) {
      Json& values = json["cases"][one.label]["sensitivity"];
      values = object_of(one.values.size());
      for (const SensitivityValue& value : one.values) {
        values[value.name] = value_json(value, parameters);
      }
    }
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
  }
  if (forms.csv) {
    report.csv.push_back(
        {.pass = "sensitivity", .text = csv_of(description.name, cases, parameters)});
  }
  if (forms.text) {
    report.text = text_of(description, file, cases, parameters);
  }
  return report;
}

}  // namespace kinestat
