#include "io/coupling_point_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// {x: 1, y: 2}, as other programs write points.
bool has_letter_keys(const YamlNode& node) {
  return !node.entries.empty() && std::ranges::all_of(node.entries, [](const YamlEntry& entry) {
    return entry.key == "x" || entry.key == "y" || entry.key == "z" || entry.key == "X" ||
           entry.key == "Y" || entry.key == "Z";
  });
}

std::optional<CouplingPoint> read_points_of_bodies(const YamlNode& node,
                                                   std::string_view what,
                                                   Space space,
                                                   Diagnostics& found) {
  const std::string_view point = space == Space::planar ? "[x, y]" : "[x, y, z]";
  if (has_letter_keys(node) || node.entries.size() != 2) {
    found.error("E0304",
                node.where,
                has_letter_keys(node) ? fmt::format("{} is a mapping of coordinates", what)
                                      : fmt::format("{} is given for {} bod{}",
                                                    what,
                                                    node.entries.size(),
                                                    node.entries.size() == 1 ? "y" : "ies"),
                fmt::format("write {}, or {{TAIL: {}, HEAD: {}}} for the point as drawn on each "
                            "of the two bodies",
                            point,
                            point,
                            point));
    return std::nullopt;
  }
  CouplingPoint result{.point = {}, .of_bodies = {}, .along_axis = {}, .where = node.where};
  for (const YamlEntry& entry : node.entries) {
    if (auto drawn = read_point(entry.value, what, space, found)) {
      result.of_bodies.push_back(
          {Name{.text = entry.key, .where = entry.key_where}, *std::move(drawn)});
    }
  }
  return result.of_bodies.size() == 2 ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace

std::optional<CouplingPoint> read_coupling_point(const YamlNode& node,
                                                 std::string_view what,
                                                 Space space,
                                                 Diagnostics& found) {
  if (node.kind == YamlKind::mapping) {
    return read_points_of_bodies(node, what, space, found);
  }
  CouplingPoint result{.point = {}, .of_bodies = {}, .along_axis = {}, .where = node.where};
  if (node.kind == YamlKind::scalar) {
    result.along_axis = read_value(node, what, found);
    return result.along_axis ? std::optional(std::move(result)) : std::nullopt;
  }
  result.point = read_point(node, what, space, found);
  return result.point ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace kinestat
