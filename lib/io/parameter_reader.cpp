#include "io/parameter_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "expression/functions.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

bool check_parameter_name(const Name& name, Diagnostics& found) {
  if (is_reserved_name(name.text)) {
    const bool is_unit = find_unit(name.text) != nullptr;
    const bool is_function = find_function(name.text) != nullptr;
    found.error("E0306",
                name.where,
                fmt::format("a parameter cannot be named '{}', which is {}",
                            name.text,
                            is_unit ? "a unit" : (is_function ? "a function" : "a constant")),
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
  for (const YamlEntry& entry : node.entries) {
    const Name name{.text = entry.key, .where = entry.key_where};
    std::optional<Value> value =
        read_value(entry.value, fmt::format("parameter '{}'", entry.key), found);
    if (check_parameter_name(name, found) && value) {
      parameters.push_back({.name = name, .value = *std::move(value)});
    }
  }
  return parameters;
}

}  // namespace kinestat
