#include "studies/sensitivity/report/sensitivity_report.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "core/text.hpp"
#include "expression/unit_quotient.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "studies/sensitivity/report/sensitivity_record.hpp"

namespace kinestat {

namespace {

using Parameters = std::vector<SensitivityParameter>;

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

// Whether no value of the case has a derivative by it.
bool has_none(const CaseSensitivity& one, std::size_t parameter) {
  return std::ranges::none_of(one.values, [parameter](const SensitivityValue& value) {
    return value.derivatives[parameter].has_value();
  });
}

// "  no derivatives by Ns1, Ns2: …"; empty if each parameter has one.
std::string lacks_text(const CaseSensitivity& one, const Parameters& parameters) {
  std::vector<std::string> names;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (has_none(one, p)) {
      names.push_back(parameters[p].name);
    }
  }
  return names.empty() ? ""
                       : fmt::format(
                             "  no derivatives by {}: of tooth numbers, of what a curve follows, "
                             "at a kink and "
                             "where the mechanism would no longer close there are none\n\n",
                             plain_list(names));
}

Table table_of(const CaseSensitivity& one,
               const SensitivityValue& value,
               const Parameters& parameters) {
  Table table({"by", "at", "derivative", "unit", "relative"});
  for (const std::size_t p : by_strength(value, parameters)) {
    if (has_none(one, p)) {
      continue;
    }
    const SensitivityParameter& parameter = parameters[p];
    const auto derivative = value.derivatives[p];
    const auto relative = relative_sensitivity(value, parameter, derivative);
    const std::string at = format_short(parameter.value);
    table.add({parameter.name,
               parameter.unit.empty() ? at : at + " " + parameter.unit,
               derivative ? format_short(*derivative) : "none",
               derivative_unit(value, parameter),
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

// Of parameters that follow from others.
std::string dependent_text(const MechanismDescription& description, const Parameters& parameters) {
  std::vector<std::string> names;
  for (const ParameterDescription& one : description.parameters) {
    const bool is_listed =
        std::ranges::find(parameters, one.name.text, &SensitivityParameter::name) !=
        parameters.end();
    const bool depends =
        std::ranges::any_of(description.parameters, [&](const ParameterDescription& other) {
          return std::ranges::count(one.value.expression.names(), other.name.text) > 0;
        });
    if (is_listed && depends) {
      names.push_back(one.name.text);
    }
  }
  return names.empty() ? ""
                       : fmt::format(
                             "Derivatives by {}, which depend{} on other parameters, are "
                             "those with the others held.\n\n",
                             plain_list(names),
                             names.size() == 1 ? "s" : "");
}

TextBlocks text_of(const MechanismDescription& description,
                   const std::string& file,
                   const std::vector<CaseSensitivity>& cases,
                   const Parameters& parameters) {
  TextBlocks text((description.name.empty() ? file : description.name) + "\n\n");
  text += dependent_text(description, parameters);
  for (const CaseSensitivity& one : cases) {
    text += fmt::format("Case {}{}\n", one.label, in_drawn_position(description));
    text += sensitivity_blocks(one, parameters);
  }
  return text;
}

}  // namespace

std::string derivative_unit(const SensitivityValue& value, const SensitivityParameter& parameter) {
  return unit_quotient(value.unit, parameter.unit);
}

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
  TextBlocks blocks(lacks_text(one, parameters));
  for (const SensitivityValue& value : one.values) {
    if (std::ranges::none_of(value.derivatives, &std::optional<double>::has_value)) {
      continue;
    }
    blocks += fmt::format("  {} = {}{}{}{}\n",
                          value.name,
                          format_short(value.value),
                          value.unit.empty() ? "" : " ",
                          value.unit,
                          note_of(value));
    blocks += TextBlocks(table_of(one, value, parameters), "    ");
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
  const SensitivityReportView view{.file = file,
                                   .description = description,
                                   .parameters = parameters,
                                   .cases = cases,
                                   .found = &found};
  add_json(sensitivity_report_record, view, description.units, forms, report);
  if (forms.csv) {
    report.csv = tables_of(sensitivity_report_record(),
                           view,
                           name_in_tables(file, description),
                           description.units,
                           MissingNumber::empty_cell,
                           "by");
  }
  if (forms.text) {
    report.text = text_of(description, file, cases, parameters);
  }
  return report;
}

}  // namespace kinestat
