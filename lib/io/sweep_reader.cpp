#include "io/sweep_reader.hpp"

#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "io/cut_value.hpp"
#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kVaryForm =
    "write {from: 15, to: 40, step: 1} or {values: [15, 17, 21]}";

std::vector<Value> read_values(const YamlNode& node, const std::string& what, Diagnostics& found) {
  std::vector<Value> values;
  if (!check_list(node, fmt::format("the values of {}", what), kVaryForm, found) ||
      report_cut_value(node, found)) {
    return values;
  }
  for (const YamlNode& item : node.items) {
    if (auto value = read_value(item, fmt::format("a value of {}", what), found)) {
      values.push_back(*std::move(value));
    }
  }
  return values;
}

void refuse_beside_values(const YamlNode& node, Fields& fields, Diagnostics& found) {
  for (const std::string_view key : {"from", "to", "step"}) {
    if (fields.find(key) != nullptr) {
      found.error("E0302",
                  place_of_key(node, key),
                  fmt::format("{} cannot have '{}' beside 'values'", fields.what(), key),
                  std::string(kVaryForm));
    }
  }
}

VariedParameter read_varied(const YamlEntry& entry, Diagnostics& found) {
  VariedParameter varied;
  varied.name = {.text = entry.key, .where = entry.key_where};
  const std::string what = fmt::format("parameter '{}' of 'vary'", entry.key);
  if (entry.value.kind != YamlKind::mapping) {
    varied.values = read_values(entry.value, what, found);
    return varied;
  }
  Fields fields(entry.value, entry.key_where, what, found);
  if (const YamlNode* values = fields.find("values")) {
    varied.values = read_values(*values, what, found);
    refuse_beside_values(entry.value, fields, found);
  } else {
    varied.from = require_value(fields, "from", found);
    varied.to = require_value(fields, "to", found);
    varied.step = require_value(fields, "step", found);
  }
  fields.finish();
  return varied;
}

std::vector<VariedParameter> read_vary(const YamlNode& node, Diagnostics& found) {
  std::vector<VariedParameter> vary;
  if (node.kind != YamlKind::mapping || node.entries.empty()) {
    found.error("E0304",
                node.where,
                "'vary' of 'sweep' must be a mapping of parameters",
                "write for example vary: {N1: {from: 15, to: 40, step: 1}}");
    return vary;
  }
  for (const YamlEntry& entry : node.entries) {
    vary.push_back(read_varied(entry, found));
  }
  return vary;
}

std::optional<Requirement> read_requirement(const YamlNode& node, Diagnostics& found) {
  const auto text = read_text(node, "a condition of 'require'", found);
  if (!text) {
    return std::nullopt;
  }
  auto parsed = parse_condition(*text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    found.error(error->code,
                place_in(node.where, node.text_column, *text, error->offset, error->length),
                error->message,
                error->hint);
    return std::nullopt;
  }
  return Requirement{.condition = std::get<Condition>(std::move(parsed)),
                     .where = node.where,
                     .text_column = node.text_column};
}

// One condition, or a list of them.
std::vector<Requirement> read_requirements(const YamlNode& node, Diagnostics& found) {
  std::vector<Requirement> requirements;
  if (report_cut_value(node, found)) {
    return requirements;
  }
  const std::span<const YamlNode> items =
      node.kind == YamlKind::sequence ? std::span(node.items) : std::span(&node, 1);
  for (const YamlNode& item : items) {
    if (auto requirement = read_requirement(item, found)) {
      requirements.push_back(*std::move(requirement));
    }
  }
  return requirements;
}

}  // namespace

std::optional<SweepDescription> read_sweep(const YamlNode& node, Diagnostics& found) {
  const int errors_before = found.error_count();
  SweepDescription sweep;
  sweep.where = node.where;
  Fields fields(node, node.where, "'sweep'", found);
  if (const YamlNode* vary = fields.require("vary")) {
    sweep.vary = read_vary(*vary, found);
  }
  if (const YamlNode* require = fields.find("require")) {
    sweep.require = read_requirements(*require, found);
  }
  sweep.cases = find_references(fields, "cases", found);
  sweep.report = find_references(fields, "report", found);
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(sweep)) : std::nullopt;
}

}  // namespace kinestat
