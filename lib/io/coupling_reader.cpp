#include "io/coupling_reader.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include <fmt/format.h>

#include "io/coupling_point_reader.hpp"
#include "io/fields.hpp"
#include "io/friction_reader.hpp"
#include "io/screw_reader.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

// Where a key is being read.
struct Place {
  std::string_view key;
  const std::string& what;  ///< "coupling 'a'"
  Space space = Space::spatial;
  Diagnostics& found;

  std::string of(std::string_view part) const { return fmt::format("the {} of {}", part, what); }
};

using ReadKey = void (*)(const YamlNode&, const Place&, CouplingDescription&);

struct KeyRow {
  std::string_view key;
  std::initializer_list<CouplingType> types;  ///< that take it; empty: all
  ReadKey read = nullptr;
};

void read_at(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.at = read_coupling_point(node, place.of("point"), place.space, place.found);
}

// A rotation axis of a planar mechanism is perpendicular to its plane.
void read_turning_axis(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.axis = read_axis(node, place.of("axis"), Space::spatial, place.found);
}

void read_sliding_axis(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.axis = read_axis(node, place.of("axis"), place.space, place.found);
}

void read_axes(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  if (node.kind != YamlKind::sequence || node.items.size() != 2) {
    place.found.error("E0304",
                      node.where,
                      fmt::format("{} must be two axes", place.of("axes")),
                      "write axes: [x, z]: the first fixed in the tail, the second in the head");
    return;
  }
  for (const YamlNode& item : node.items) {
    if (auto axis = read_axis(item, place.of("axes"), place.space, place.found)) {
      coupling.axes.push_back(*std::move(axis));
    }
  }
}

template <std::optional<AxisDescription> CouplingDescription::*member>
void read_direction(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.*member = read_axis(node, place.of("direction"), place.space, place.found);
}

template <std::optional<Value> CouplingDescription::*member>
void read_quantity(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.*member = read_value(node, place.what, place.found);
}

// radii: [31, flat]
void read_radii(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  if (node.kind != YamlKind::sequence || node.items.size() != 2) {
    place.found.error("E0304",
                      node.where,
                      fmt::format("{} must be two, of the tail and of the head", place.of("radii")),
                      "write for example radii: [31, 10], or radii: [31, flat]");
    return;
  }
  for (const YamlNode& item : node.items) {
    if (item.kind == YamlKind::scalar && item.text == "flat") {
      coupling.radii.emplace_back(std::nullopt);
    } else if (auto radius = read_value(item, place.of("radius"), place.found)) {
      coupling.radii.emplace_back(*std::move(radius));
    }
  }
}

template <bool CouplingDescription::*member>
void read_flag(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.*member = read_bool(node, fmt::format("'{}'", place.key), place.found).value_or(false);
}

template <std::optional<PointDescription> CouplingDescription::*member>
void read_end(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.*member = read_point(node, place.of("end"), place.space, place.found);
}

template <std::vector<ScrewDescription> CouplingDescription::*member>
void read_screw_list(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.*member = read_screws(node, place.what, place.space, place.found);
}

void read_relative_screw(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  if (auto screw = read_screw(node, place.of("relative screw"), place.space, place.found)) {
    coupling.screw = std::make_shared<const ScrewDescription>(*std::move(screw));
  }
}

void read_one_way(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  static const std::vector<std::string> kSigns = {"+", "-"};
  if (const auto word = read_word(node, place.of("bearing direction"), kSigns, place.found)) {
    coupling.one_way = *word == 0 ? OneWay::positive : OneWay::negative;
  }
}

void read_passive(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  coupling.passive = read_references(node, place.of("constraint"), place.found);
}

FrictionKind friction_kind(CouplingType type) {
  switch (type) {
    case revolute:
      return FrictionKind::journal;
    case helical:
      return FrictionKind::thread;
    case prismatic:
      return FrictionKind::guide;
    case point_contact:
    case cam:
    case line_contact:
    case pin_in_slot:
    case gear:
    case bevel_gear:
    case worm:
    case rack:
      return FrictionKind::sliding;
    default:
      return FrictionKind::whatever;
  }
}

void read_coupling_friction(const YamlNode& node,
                            const Place& place,
                            CouplingDescription& coupling) {
  if (auto friction =
          read_friction(node, friction_kind(coupling.type), place.of("friction"), place.found)) {
    coupling.friction = std::make_shared<const FrictionDescription>(*std::move(friction));
  }
}

void read_stiffness(const YamlNode& node, const Place& place, CouplingDescription& coupling) {
  if (node.kind != YamlKind::mapping) {
    place.found.error(
        "E0304",
        node.where,
        fmt::format("{} must be a mapping of actions to values", place.of("stiffness")),
        "write for example stiffness: {Rx: 2e6 N/m}");
    return;
  }
  for (const YamlEntry& entry : node.entries) {
    if (auto value = read_value(entry.value, fmt::format("'{}'", entry.key), place.found)) {
      coupling.stiffness.push_back(
          {.action = {.text = entry.key, .where = entry.key_where}, .value = *std::move(value)});
    }
  }
}

// Which types take which keys, beside `type` and `bodies`.
const std::initializer_list<KeyRow> kKeys = {
    {"at",
     {revolute,
      prismatic,
      helical,
      cylindrical,
      universal,
      spherical,
      planar,
      point_contact,
      cam,
      line_contact,
      sphere_in_tube,
      pin_in_slot,
      rigid,
      gear,
      bevel_gear,
      worm,
      rack,
      clutch,
      brake},
     read_at},
    {"axis",
     {revolute, helical, cylindrical, sphere_in_tube, gear, bevel_gear, worm, rack, clutch, brake},
     read_turning_axis},
    {"axis", {prismatic}, read_sliding_axis},
    {"axes", {universal}, read_axes},
    {"normal",
     {planar, point_contact, cam, line_contact},
     read_direction<&CouplingDescription::normal>},
    {"line", {line_contact}, read_direction<&CouplingDescription::line>},
    {"radii", {point_contact, cam, line_contact}, read_radii},
    {"slot", {pin_in_slot}, read_direction<&CouplingDescription::slot>},
    {"pitch", {helical}, read_quantity<&CouplingDescription::pitch>},
    {"lead", {helical}, read_quantity<&CouplingDescription::lead>},
    {"tangent", {gear}, read_direction<&CouplingDescription::tangent>},
    {"pressure_angle", {gear}, read_quantity<&CouplingDescription::pressure_angle>},
    {"helix_angle", {gear}, read_quantity<&CouplingDescription::helix_angle>},
    {"internal", {gear}, read_flag<&CouplingDescription::internal>},
    {"contact", {gear}, read_flag<&CouplingDescription::contact>},
    {"line_of_action",
     {gear, bevel_gear, worm, rack},
     read_direction<&CouplingDescription::line_of_action>},
    {"screw", {bevel_gear, worm, rack}, read_relative_screw},
    {"from", {cable}, read_end<&CouplingDescription::from>},
    {"to", {cable}, read_end<&CouplingDescription::to>},
    {"freedoms", {screws}, read_screw_list<&CouplingDescription::freedoms>},
    {"constraints", {screws}, read_screw_list<&CouplingDescription::constraints>},
    {"one_way", {clutch, brake}, read_one_way},
    {"passive", {}, read_passive},
    {"friction", {}, read_coupling_friction},
    {"stiffness", {}, read_stiffness},
};

bool takes(const KeyRow& row, CouplingType type) {
  return row.types.size() == 0 || std::ranges::find(row.types, type) != row.types.end();
}

void refuse_ends(const YamlNode& node, const std::string& what, Diagnostics& found) {
  const std::size_t count = node.items.size();
  const std::string listed = count == 1 ? with_commas(node.items.front()) : with_commas(node);
  found.error(
      "E0304",
      node.where,
      node.kind == YamlKind::sequence
          ? fmt::format(
                "{} joins {} bod{}, it must join two", what, count, count == 1 ? "y" : "ies")
          : fmt::format("{} must join two bodies", what),
      fmt::format("write bodies: [{}]{}; motions are those of the head relative to the tail",
                  listed.empty() ? "tail, head" : listed,
                  listed.empty() ? "" : ": a comma between the names"));
}

// bodies: [tail, head]
void read_ends(Fields& fields, CouplingDescription& coupling, Diagnostics& found) {
  const YamlNode* node = fields.require("bodies");
  if (node == nullptr) {
    return;
  }
  if (node->kind != YamlKind::sequence || node->items.size() != 2) {
    refuse_ends(*node, fields.what(), found);
    return;
  }
  coupling.tail = read_reference(node->items[0], "the tail", found).value_or(Name{});
  coupling.head = read_reference(node->items[1], "the head", found).value_or(Name{});
}

// The type, or empty after an error.
std::optional<CouplingType> read_type(const YamlNode& node, Diagnostics& found) {
  const std::vector<std::string> words = coupling_type_words();
  const auto word = read_word(node, "the type of a coupling", words, found);
  return word ? find_coupling_type(words[*word]) : std::nullopt;
}

std::optional<CouplingDescription> read_coupling(const YamlEntry& entry,
                                                 Space space,
                                                 Diagnostics& found) {
  CouplingDescription coupling;
  coupling.name = {.text = entry.key, .where = entry.key_where};
  const int errors_before = found.error_count();
  check_name(coupling.name, "a coupling", found);
  Fields fields(entry.value, entry.key_where, fmt::format("coupling '{}'", entry.key), found);
  const YamlNode* type = fields.require("type");
  if (type != nullptr) {
    const std::optional<CouplingType> known = read_type(*type, found);
    if (!known) {
      return std::nullopt;  // which other keys may stand depends on the type
    }
    coupling.type = *known;
  }
  read_ends(fields, coupling, found);
  for (const KeyRow& row : kKeys) {
    if (type == nullptr || takes(row, coupling.type)) {
      if (const YamlNode* node = fields.find(row.key)) {
        row.read(*node,
                 {.key = row.key, .what = fields.what(), .space = space, .found = found},
                 coupling);
      }
    }
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(coupling)) : std::nullopt;
}

}  // namespace

std::vector<CouplingDescription> read_couplings(const YamlNode& node,
                                                Space space,
                                                Diagnostics& found) {
  std::vector<CouplingDescription> couplings;
  if (!check_mapping(node, "couplings", found)) {
    return couplings;
  }
  // They are large, and most have at least a type and bodies.
  couplings.reserve(static_cast<std::size_t>(std::ranges::count_if(
      node.entries, [](const YamlEntry& entry) { return entry.value.entries.size() >= 2; })));
  for (const YamlEntry& entry : node.entries) {
    if (auto coupling = read_coupling(entry, space, found)) {
      couplings.push_back(*std::move(coupling));
    }
  }
  return couplings;
}

}  // namespace kinestat
