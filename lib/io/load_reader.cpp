#include "io/load_reader.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// About z it is one number; in space it is a vector.
void read_couple(Fields& fields, Space space, LoadDescription& load, Diagnostics& found) {
  const YamlNode* node = fields.find("couple");
  if (node == nullptr) {
    return;
  }
  const std::string what = fmt::format("'couple' of {}", fields.what());
  if (space == Space::spatial) {
    if (auto vector = read_point(*node, what, space, found)) {
      load.couple = std::move(vector->coordinates);
    }
    return;
  }
  if (node->kind == YamlKind::sequence) {
    found.error("E0304",
                node->where,
                fmt::format("{} is one number about z in planar space", what),
                "write for example couple: 5 N*m");
  } else if (auto value = read_value(*node, what, found)) {
    load.couple.push_back(*std::move(value));
  }
}

// A force acts at a point, a couple anywhere.
void check_keys(const YamlNode& node, const Fields& fields, Diagnostics& found) {
  const bool has_force = node.find("force") != nullptr;
  const bool has_point = node.find("at") != nullptr;
  if (!has_force && node.find("couple") == nullptr) {
    found.error("E0303",
                fields.where(),
                fmt::format("{} has neither 'force' nor 'couple'", fields.what()),
                "add 'force: […]' with its point 'at: […]', or 'couple: …'");
  } else if (has_force && !has_point) {
    found.error("E0303",
                place_of_key(node, "force"),
                fmt::format("the force of {} has no point where it acts", fields.what()),
                "add 'at: […]', a point in the drawn position");
  } else if (has_point && !has_force) {
    found.error("E0302",
                place_of_key(node, "at"),
                fmt::format("{} has 'at' but no force that acts there", fields.what()),
                "remove 'at': a couple is the same at every point; or add 'force: […]'");
  }
}

LoadDescription read_load(const YamlEntry& entry, Space space, Diagnostics& found) {
  LoadDescription load;
  load.name = {.text = entry.key, .where = entry.key_where};
  check_name(load.name, "a load", found);
  Fields fields(entry.value, entry.key_where, fmt::format("load '{}'", entry.key), found);
  load.body = require_reference(fields, "body", found);
  load.at = find_point(fields, "at", space, found);
  load.force = find_point(fields, "force", space, found);
  read_couple(fields, space, load, found);
  fields.finish();
  if (entry.value.kind == YamlKind::mapping) {
    check_keys(entry.value, fields, found);
  }
  return load;
}

}  // namespace

std::vector<LoadDescription> read_loads(const YamlNode& node, Space space, Diagnostics& found) {
  std::vector<LoadDescription> loads;
  if (!check_mapping(node, "loads", found)) {
    return loads;
  }
  for (const YamlEntry& entry : node.entries) {
    const int errors_before = found.error_count();
    LoadDescription load = read_load(entry, space, found);
    if (found.error_count() == errors_before) {
      loads.push_back(std::move(load));
    }
  }
  return loads;
}

}  // namespace kinestat
