#include "io/body_reader.hpp"

#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

BodyDescription read_body(const YamlEntry& entry, Space space, Diagnostics& found) {
  BodyDescription body{.name = {.text = entry.key, .where = entry.key_where}, .reference = {}};
  if (entry.value.kind == YamlKind::null) {
    return body;
  }
  Fields fields(entry.value, entry.key_where, fmt::format("body '{}'", entry.key), found);
  if (const YamlNode* node = fields.find("reference")) {
    body.reference =
        read_point(*node, fmt::format("the reference point of {}", fields.what()), space, found);
  }
  fields.finish();
  return body;
}

}  // namespace

std::vector<BodyDescription> read_bodies(const YamlNode& node, Space space, Diagnostics& found) {
  std::vector<BodyDescription> bodies;
  if (node.kind == YamlKind::sequence) {
    for (const YamlNode& item : node.items) {
      if (const auto name = read_reference(item, "a body", found);
          name && check_name(*name, "a body", found)) {
        bodies.push_back({.name = *name, .reference = {}});
      }
    }
  } else if (node.kind == YamlKind::mapping) {
    for (const YamlEntry& entry : node.entries) {
      BodyDescription body = read_body(entry, space, found);
      if (check_name(body.name, "a body", found)) {
        bodies.push_back(std::move(body));
      }
    }
  } else {
    found.error("E0304",
                node.where,
                "'bodies' must be a list of names, or a mapping with attributes",
                "write bodies: [crank, coupler, rocker]");
  }
  return bodies;
}

}  // namespace kinestat
