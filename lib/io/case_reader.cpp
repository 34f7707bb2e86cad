#include "io/case_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/load_reader.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

std::vector<Assignment> read_assignments(const YamlNode& node,
                                         const std::string& what,
                                         Diagnostics& found) {
  std::vector<Assignment> assignments;
  if (node.kind != YamlKind::mapping) {
    found.error("E0304",
                node.where,
                fmt::format("{} must be a mapping of names to values", what),
                "write for example {drive: 1 rad/s}");
    return assignments;
  }
  for (const YamlEntry& entry : node.entries) {
    if (auto value = read_value(entry.value, fmt::format("'{}'", entry.key), found)) {
      assignments.push_back(
          {.target = {.text = entry.key, .where = entry.key_where}, .value = *std::move(value)});
    }
  }
  return assignments;
}

// The actuators of `input` or `output`: one name or a list of them.
std::vector<Name> read_ends(Fields& fields, std::string_view key, Diagnostics& found) {
  const YamlNode* node = fields.find(key);
  if (node != nullptr && node->kind == YamlKind::sequence && node->items.empty()) {
    found.error("E0304",
                node->where,
                fmt::format("'{}' of {} is an empty list", key, fields.what()),
                fmt::format("name an actuator, or remove '{}'", key));
    return {};
  }
  return node == nullptr
             ? std::vector<Name>()
             : read_references(*node, fmt::format("'{}' of {}", key, fields.what()), found)
                   .value_or(std::vector<Name>{});
}

// A ratio needs both; an input alone says whose power counts as input.
void check_ends(const YamlEntry& entry, const CaseDescription& result, Diagnostics& found) {
  const auto output = std::ranges::find(entry.value.entries, "output", &YamlEntry::key);
  if (output != entry.value.entries.end() && entry.value.find("input") == nullptr) {
    found.error("E0303",
                output->key_where,
                fmt::format("case '{}' names an output but no input", result.label.text),
                "add 'input: NAME', an actuator, or remove 'output'");
  }
}

CaseDescription read_case(const YamlEntry& entry, Space space, Diagnostics& found) {
  CaseDescription result;
  result.label = {.text = entry.key, .where = entry.key_where};
  Fields fields(entry.value, entry.key_where, fmt::format("case '{}'", entry.key), found);
  const YamlNode* motion = fields.find("motion");
  result.asks_motions = motion != nullptr;
  if (motion != nullptr) {
    result.motions = read_assignments(*motion, "'motion'", found);
  }
  const YamlNode* action = fields.find("action");
  result.asks_actions = action != nullptr;
  if (action != nullptr) {
    result.actions = read_assignments(*action, "'action'", found);
  }
  const YamlNode* loads = fields.find("loads");
  if (loads != nullptr) {
    result.loads = read_loads(*loads, space, found);
  }
  const bool is_empty = motion == nullptr && action == nullptr && loads == nullptr;
  if (entry.value.kind == YamlKind::mapping && is_empty) {
    found.error(
        "E0303",
        entry.key_where,
        fmt::format("case '{}' names neither motions nor actions", entry.key),
        "add 'motion: {…}' for velocities, 'action: {…}' or 'loads: {…}' for forces, or both");
  }
  result.inputs = read_ends(fields, "input", found);
  result.outputs = read_ends(fields, "output", found);
  check_ends(entry, result, found);
  fields.finish();
  return result;
}

// A key of a case that is indented like its label, which is then empty.
const YamlEntry* find_misplaced_key(const YamlNode& node) {
  const bool has_empty_label = std::ranges::any_of(
      node.entries, [](const YamlEntry& entry) { return entry.value.kind == YamlKind::null; });
  const auto at = std::ranges::find_if(node.entries, [](const YamlEntry& entry) {
    return entry.key == "motion" || entry.key == "action" || entry.key == "loads";
  });
  return has_empty_label && at != node.entries.end() ? &*at : nullptr;
}

}  // namespace

std::vector<CaseDescription> read_cases(const YamlNode& node, Space space, Diagnostics& found) {
  std::vector<CaseDescription> cases;
  if (node.kind != YamlKind::mapping) {
    found.error("E0304",
                node.where,
                "'cases' must be a mapping of labels",
                "write cases: and below it indented lines 'label: {motion: {…}}'");
    return cases;
  }
  if (const YamlEntry* key = find_misplaced_key(node)) {
    found.error("E0304",
                key->key_where,
                fmt::format("'{}' stands beside the labels of the cases", key->key),
                "a case is 'label:' with its keys below it, indented further");
    return cases;
  }
  cases.reserve(node.entries.size());
  for (const YamlEntry& entry : node.entries) {
    cases.push_back(read_case(entry, space, found));
  }
  return cases;
}

}  // namespace kinestat
