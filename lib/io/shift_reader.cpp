#include "io/shift_reader.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// One value for every input, or a mapping of actuators to values.
std::vector<InputValue> find_input_values(Fields& fields,
                                          std::string_view key,
                                          Diagnostics& found) {
  std::vector<InputValue> values;
  const YamlNode* node = fields.find(key);
  if (node == nullptr) {
    return values;
  }
  if (node->kind != YamlKind::mapping) {
    const std::string what = fmt::format("'{}' of 'shift'", key);
    if (auto value = read_value(*node, what, found)) {
      values.push_back({.target = std::nullopt, .value = *std::move(value)});
    }
    return values;
  }
  for (const YamlEntry& entry : node->entries) {
    const std::string what = fmt::format("'{}' of '{}'", key, entry.key);
    if (auto value = read_value(entry.value, what, found)) {
      values.push_back({.target = Name{.text = entry.key, .where = entry.key_where},
                        .value = *std::move(value)});
    }
  }
  return values;
}

std::vector<GearLabel> read_labels(const YamlNode& node, Diagnostics& found) {
  std::vector<GearLabel> labels;
  if (node.kind != YamlKind::mapping) {
    found.error("E0304",
                node.where,
                "'names' of 'shift' must be a mapping of labels to elements",
                "write for example names: {M1: [C1, B2]}");
    return labels;
  }
  for (const YamlEntry& entry : node.entries) {
    const std::string what = fmt::format("gear '{}'", entry.key);
    if (auto elements = read_references(entry.value, what, found)) {
      labels.push_back({.label = {.text = entry.key, .where = entry.key_where},
                        .elements = *std::move(elements)});
    }
  }
  return labels;
}

}  // namespace

std::optional<ShiftDescription> read_shift(const YamlNode& node, Diagnostics& found) {
  const int errors_before = found.error_count();
  ShiftDescription shift;
  shift.where = node.where;
  Fields fields(node, node.where, "'shift'", found);
  shift.inputs = require_references(fields, "input", found);
  shift.outputs = require_references(fields, "output", found);
  shift.elements = require_references(fields, "elements", found);
  shift.input_motion = find_input_values(fields, "input_motion", found);
  shift.input_action = find_input_values(fields, "input_action", found);
  if (const YamlNode* names = fields.find("names")) {
    shift.names = read_labels(*names, found);
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(shift)) : std::nullopt;
}

}  // namespace kinestat
