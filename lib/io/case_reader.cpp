#include "io/case_reader.hpp"

#include <fmt/format.h>

#include "io/fields.hpp"
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

CaseDescription read_case(const YamlEntry& entry, Diagnostics& found) {
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
  if (entry.value.kind == YamlKind::mapping && motion == nullptr && action == nullptr) {
    found.error("E0303",
                entry.key_where,
                fmt::format("case '{}' names neither motions nor actions", entry.key),
                "add 'motion: {…}' for velocities, 'action: {…}' for forces, or both");
  }
  if (const YamlNode* node = fields.find("input")) {
    result.inputs = read_references(*node, "the input", found).value_or(std::vector<Name>{});
  }
  if (const YamlNode* node = fields.find("output")) {
    result.outputs = read_references(*node, "the output", found).value_or(std::vector<Name>{});
  }
  fields.finish();
  return result;
}

}  // namespace

std::vector<CaseDescription> read_cases(const YamlNode& node, Diagnostics& found) {
  std::vector<CaseDescription> cases;
  if (node.kind != YamlKind::mapping) {
    found.error("E0304",
                node.where,
                "'cases' must be a mapping of labels",
                "write cases: and below it indented lines 'label: {motion: {…}}'");
    return cases;
  }
  for (const YamlEntry& entry : node.entries) {
    cases.push_back(read_case(entry, found));
  }
  return cases;
}

}  // namespace kinestat
