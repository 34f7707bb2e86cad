#include "io/body_reader.hpp"

#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

std::vector<PointDescription> read_outline(const YamlNode& node,
                                           std::string_view what,
                                           Space space,
                                           Diagnostics& found) {
  std::vector<PointDescription> points;
  if (node.kind != YamlKind::sequence) {
    found.error("E0304",
                node.where,
                fmt::format("the outline of {} must be a list of points", what),
                space == Space::planar ? "write outline: [[0, 0], [2, 0], [1, 1]]"
                                       : "write outline: [[0, 0, 0], [2, 0, 0], [1, 1, 0]]");
    return points;
  }
  for (const YamlNode& item : node.items) {
    if (auto point = read_point(item, fmt::format("the outline of {}", what), space, found)) {
      points.push_back(*std::move(point));
    }
  }
  return points;
}

BodyDescription read_body(const YamlEntry& entry, Space space, Diagnostics& found) {
  BodyDescription body;
  body.name = {.text = entry.key, .where = entry.key_where};
  if (entry.value.kind == YamlKind::null) {
    return body;
  }
  Fields fields(entry.value, entry.key_where, fmt::format("body '{}'", entry.key), found);
  const std::string& what = fields.what();
  if (const YamlNode* node = fields.find("reference")) {
    body.reference =
        read_point(*node, fmt::format("the reference point of {}", what), space, found);
  }
  if (const YamlNode* node = fields.find("mass")) {
    body.mass = read_value(*node, fmt::format("the mass of {}", what), found);
  }
  if (const YamlNode* node = fields.find("centre_of_mass")) {
    body.centre_of_mass =
        read_point(*node, fmt::format("the centre of mass of {}", what), space, found);
  }
  if (const YamlNode* node = fields.find("outline")) {
    body.outline = read_outline(*node, what, space, found);
  }
  fields.finish();
  return body;
}

}  // namespace

std::vector<BodyDescription> read_bodies(const YamlNode& node, Space space, Diagnostics& found) {
  std::vector<BodyDescription> bodies;
  bodies.reserve(node.items.size() + node.entries.size());
  if (node.kind == YamlKind::sequence) {
    for (const YamlNode& item : node.items) {
      if (const auto name = read_reference(item, "a body", found);
          name && check_name(*name, "a body", found)) {
        BodyDescription body;
        body.name = *name;
        bodies.push_back(std::move(body));
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
