#include "io/parameter_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "expression/functions.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// What else in an expression has this name.
std::string_view meaning_of(std::string_view reserved) {
  if (find_unit(reserved) != nullptr) {
    return "a unit";
  }
  if (find_function(reserved) != nullptr) {
    return "a function";
  }
  return is_condition_word(reserved) ? "a word of conditions" : "a constant";
}

bool check_parameter_name(const Name& name, Diagnostics& found) {
  if (is_reserved_name(name.text)) {
    found.error(
        "E0306",
        name.where,
        fmt::format(
            "a parameter cannot be named '{}', which is {}", name.text, meaning_of(name.text)),
        fmt::format("call it '{}_1', or by a longer word", name.text));
    return false;
  }
  if (name.text.find('-') != std::string::npos) {
    std::string better = name.text;
    std::ranges::replace(better, '-', '_');
    found.error("E0306",
                name.where,
                fmt::format("parameter '{}' would be read as a difference", name.text),
                fmt::format("call it '{}'", better));
    return false;
  }
  return check_name(name, "a parameter", found);
}

// A number or expression, or {free: value}.
std::optional<ParameterDescription> read_parameter(const YamlEntry& entry, Diagnostics& found) {
  const std::string what = fmt::format("parameter '{}'", entry.key);
  const bool is_mapping = entry.value.kind == YamlKind::mapping;
  std::optional<Value> value;
  if (is_mapping) {
    Fields fields(entry.value, entry.key_where, what, found);
    if (const YamlNode* node = fields.require("free")) {
      value = read_value(*node, what, found);
    }
    fields.finish();
  } else {
    value = read_value(entry.value, what, found);
  }
  const Name name{.text = entry.key, .where = entry.key_where};
  if (!check_parameter_name(name, found) || !value) {
    return std::nullopt;
  }
  return ParameterDescription{.name = name, .value = *std::move(value), .is_free = is_mapping};
}

}  // namespace

void read_units(const YamlNode& node, FileUnits& units, Diagnostics& found) {
  Fields fields(node, node.where, "'units'", found);
  for (const QuantityKind kind : all_quantity_kinds()) {
    const std::string_view key = key_of(kind);
    const YamlNode* entry = key.empty() ? nullptr : fields.find(key);
    if (entry == nullptr) {
      continue;
    }
    const auto text = read_text(*entry, fmt::format("the unit of '{}'", key), found);
    if (!text) {
      continue;
    }
    if (const auto error = units.set(kind, *text)) {
      found.error(error->code,
                  place_in(entry->where, entry->text_column, *text, error->offset, error->length),
                  error->message,
                  error->hint);
    }
  }
  fields.finish();
}

std::vector<ParameterDescription> read_parameters(const YamlNode& node, Diagnostics& found) {
  std::vector<ParameterDescription> parameters;
  if (node.kind != YamlKind::mapping) {
    found.error("E0304",
                node.where,
                "'parameters' must be a mapping of names to values",
                "write parameters: and below it indented lines 'name: value'");
    return parameters;
  }
  parameters.reserve(node.entries.size());
  for (const YamlEntry& entry : node.entries) {
    if (auto parameter = read_parameter(entry, found)) {
      parameters.push_back(*std::move(parameter));
    }
  }
  return parameters;
}

}  // namespace kinestat
