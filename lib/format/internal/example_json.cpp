#include "format/internal/example_json.hpp"

#include <optional>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/spelling.hpp"
#include "expression/parse/decimal_to_double.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

namespace {

Json scalar_json(const YamlNode& node) {
  if (is_truth_value(node)) {
    return node.text == "true";
  }
  if (const auto whole = node.quoted ? std::nullopt : number_from<long>(node.text)) {
    return *whole;
  }
  if (const auto number = node.quoted ? std::nullopt : read_plain_number(node.text)) {
    return *number;
  }
  return node.text;
}

Json json_of(const YamlNode& node) {
  Json json;
  switch (node.kind) {
    case YamlKind::null:
      break;
    case YamlKind::scalar:
      return scalar_json(node);
    case YamlKind::sequence:
      json = Json::array();
      for (const YamlNode& item : node.items) {
        json.push_back(json_of(item));
      }
      break;
    case YamlKind::mapping:
      json = Json::object();
      for (const YamlEntry& entry : node.entries) {
        json[entry.key] = json_of(entry.value);
      }
      break;
  }
  return json;
}

std::string scalar_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string placeholders(const Json& example, int& count) {
  std::string text;
  if (example.is_object()) {
    for (const auto& [key, value] : example.items()) {
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, placeholders(value, count));
    }
    return "{" + text + "}";
  }
  if (example.is_array()) {
    for (const Json& item : example) {
      text += (text.empty() ? "" : ", ") + placeholders(item, count);
    }
    return "[" + text + "]";
  }
  ++count;
  return fmt::format("${{{}:{}}}", count, scalar_text(example));
}

}  // namespace

Json example_json(const std::string& text) {
  Diagnostics found;
  const auto root =
      read_yaml({.path = "example", .text = "example: " + text + "\n"}, ReadLimits{}, found);
  KINESTAT_EXPECTS(root.has_value());
  return json_of(root->entries.front().value);
}

std::string flow_snippet(const Json& example) {
  int count = 0;
  return placeholders(example, count);
}

Json line_snippet(const Json& example) {
  int count = 0;
  Json lines = Json::object();
  for (const auto& [key, value] : example.items()) {
    lines[key] = placeholders(value, count);
  }
  return lines;
}

std::string outline(const Json& example) {
  std::string text;
  if (example.is_object()) {
    for (const auto& [key, value] : example.items()) {
      text += (text.empty() ? "" : ", ") + key;
    }
    return "{" + text + "}";
  }
  if (example.is_array()) {
    for (const Json& item : example) {
      text += (text.empty() ? "" : ", ") + outline(item);
    }
    return "[" + text + "]";
  }
  return scalar_text(example);
}

}  // namespace kinestat
