#include "io/gear_reader.hpp"

#include <string>

#include <fmt/format.h>

#include "io/field_values.hpp"
#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// What only a planet has.
void refuse_of_ring(const YamlNode& node, const Fields& fields, Diagnostics& found) {
  for (const std::string_view key : {"count", "centre_distance", "side"}) {
    if (node.find(key) != nullptr) {
      found.error("E0302",
                  place_of_key(node, key),
                  fmt::format("{} is a ring and cannot have '{}'", fields.what(), key),
                  fmt::format("remove '{}', or 'internal: true' if it is a planet", key));
    }
  }
}

GearMember read_member(const YamlEntry& entry, Diagnostics& found) {
  static const std::vector<std::string> kSides = {"left", "right"};
  GearMember member;
  member.name = {.text = entry.key, .where = entry.key_where};
  check_name(member.name, "a gear member", found);
  Fields fields(entry.value, entry.key_where, fmt::format("gear member '{}'", entry.key), found);
  member.body = require_reference(fields, "body", found);
  member.teeth = require_value(fields, "teeth", found);
  member.internal = find_bool(fields, "internal", found);
  member.count = find_value(fields, "count", found);
  member.centre_distance = find_value(fields, "centre_distance", found);
  const bool is_right = find_word(fields, "side", kSides, found) == std::size_t{1};
  member.side = is_right ? PlanetSide::right : PlanetSide::left;
  fields.finish();
  if (member.internal) {
    refuse_of_ring(entry.value, fields, found);
  }
  return member;
}

// members: [first, second]
void read_pair(Fields& fields, MeshDescription& mesh, Diagnostics& found) {
  const YamlNode* node = fields.require("members");
  if (node == nullptr) {
    return;
  }
  if (node->kind != YamlKind::sequence || node->items.size() != 2) {
    found.error("E0304",
                node->where,
                fmt::format("{} must join two gear members", fields.what()),
                "write members: [first, second]; a gear that meets two others has two meshes");
    return;
  }
  mesh.first = read_reference(node->items[0], "a gear member", found).value_or(Name{});
  mesh.second = read_reference(node->items[1], "a gear member", found).value_or(Name{});
}

MeshDescription read_mesh(const YamlEntry& entry, Diagnostics& found) {
  MeshDescription mesh;
  mesh.name = {.text = entry.key, .where = entry.key_where};
  check_name(mesh.name, "a mesh", found);
  Fields fields(entry.value, entry.key_where, fmt::format("mesh '{}'", entry.key), found);
  read_pair(fields, mesh, found);
  mesh.carrier = find_reference(fields, "carrier", found);
  mesh.at = find_value(fields, "at", found);
  mesh.module = find_value(fields, "module", found);
  mesh.pressure_angle = find_value(fields, "pressure_angle", found);
  mesh.helix_angle = find_value(fields, "helix_angle", found);
  fields.finish();
  return mesh;
}

template <class Item>
std::vector<Item> read_items(Fields& fields,
                             std::string_view key,
                             Item (*read)(const YamlEntry&, Diagnostics&),
                             Diagnostics& found) {
  std::vector<Item> items;
  const YamlNode* node = fields.require(key);
  if (node == nullptr || !check_mapping(*node, key, found)) {
    return items;
  }
  for (const YamlEntry& entry : node->entries) {
    items.push_back(read(entry, found));
  }
  return items;
}

}  // namespace

std::optional<GearsDescription> read_gears(const YamlNode& node, Diagnostics& found) {
  static const std::vector<std::string> kFlanks = {"loaded", "fixed"};
  const int errors_before = found.error_count();
  GearsDescription gears;
  gears.where = node.where;
  Fields fields(node, node.where, "'gears'", found);
  gears.module = find_value(fields, "module", found);
  gears.pressure_angle = find_value(fields, "pressure_angle", found);
  gears.helix_angle = find_value(fields, "helix_angle", found);
  const bool is_fixed = find_word(fields, "flank", kFlanks, found) == std::size_t{1};
  gears.flank = is_fixed ? Flank::fixed : Flank::loaded;
  gears.members = read_items(fields, "members", read_member, found);
  gears.meshes = read_items(fields, "meshes", read_mesh, found);
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(gears)) : std::nullopt;
}

}  // namespace kinestat
