#include "io/coupling_reader.hpp"

#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

bool check_mapping(const YamlNode& node, std::string_view section, Diagnostics& found) {
  if (node.kind == YamlKind::mapping) {
    return true;
  }
  found.error("E0304",
              node.where,
              fmt::format("'{}' must be a mapping of names", section),
              fmt::format("write {}: and below it indented lines 'name: {{…}}'", section));
  return false;
}

// bodies: [tail, head]
void read_ends(Fields& fields, CouplingDescription& coupling, Diagnostics& found) {
  const YamlNode* node = fields.require("bodies");
  if (node == nullptr) {
    return;
  }
  if (node->kind != YamlKind::sequence || node->items.size() != 2) {
    found.error("E0304",
                node->where,
                fmt::format("{} must join two bodies", fields.what()),
                "write bodies: [tail, head]; motions are those of the head relative to the tail");
    return;
  }
  coupling.tail = read_reference(node->items[0], "the tail", found).value_or(Name{});
  coupling.head = read_reference(node->items[1], "the head", found).value_or(Name{});
}

void read_gear(Fields& fields, Space space, CouplingDescription& coupling, Diagnostics& found) {
  if (const YamlNode* node = fields.find("tangent")) {
    coupling.tangent = read_axis(*node, "the tangent", space, found);
  }
  if (const YamlNode* node = fields.find("line_of_action")) {
    coupling.line_of_action = read_axis(*node, "the line of action", space, found);
  }
  if (const YamlNode* node = fields.find("pressure_angle")) {
    coupling.pressure_angle = read_value(*node, "the pressure angle", found);
  }
  if (const YamlNode* node = fields.find("internal")) {
    coupling.internal = read_bool(*node, "'internal'", found).value_or(false);
  }
}

void read_geometry(Fields& fields, Space space, CouplingDescription& coupling, Diagnostics& found) {
  if (const YamlNode* node = fields.find("at")) {
    coupling.at = read_point(*node, fmt::format("the point of {}", fields.what()), space, found);
  }
  if (coupling.type != CouplingType::rigid) {
    if (const YamlNode* node = fields.find("axis")) {
      // A rotation axis of a planar mechanism is perpendicular to its plane.
      const bool may_be_vector =
          space == Space::spatial || coupling.type == CouplingType::prismatic;
      coupling.axis = read_axis(*node, "the axis", may_be_vector ? space : Space::spatial, found);
    }
  }
  if (const YamlNode* node = fields.find("passive")) {
    coupling.passive = read_references(*node, "'passive'", found);
  }
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
    const std::vector<std::string> words = coupling_type_words();
    const auto word = read_word(*type, "the type of a coupling", words, found);
    if (!word) {
      return std::nullopt;  // which other keys may stand depends on the type
    }
    coupling.type = *find_coupling_type(words[*word]);
  }
  read_ends(fields, coupling, found);
  read_geometry(fields, space, coupling, found);
  if (coupling.type == CouplingType::gear || type == nullptr) {
    read_gear(fields, space, coupling, found);
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(coupling)) : std::nullopt;
}

std::optional<ActuatorDescription> read_actuator(const YamlEntry& entry, Diagnostics& found) {
  ActuatorDescription actuator;
  actuator.name = {.text = entry.key, .where = entry.key_where};
  const int errors_before = found.error_count();
  check_name(actuator.name, "an actuator", found);
  Fields fields(entry.value, entry.key_where, fmt::format("actuator '{}'", entry.key), found);
  if (const YamlNode* node = fields.require("coupling")) {
    actuator.coupling = read_reference(*node, "the coupling", found).value_or(Name{});
  }
  if (const YamlNode* node = fields.find("freedom")) {
    actuator.freedom = read_reference(*node, "the freedom", found);
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(actuator)) : std::nullopt;
}

}  // namespace

std::vector<CouplingDescription> read_couplings(const YamlNode& node,
                                                Space space,
                                                Diagnostics& found) {
  std::vector<CouplingDescription> couplings;
  if (!check_mapping(node, "couplings", found)) {
    return couplings;
  }
  for (const YamlEntry& entry : node.entries) {
    if (auto coupling = read_coupling(entry, space, found)) {
      couplings.push_back(*std::move(coupling));
    }
  }
  return couplings;
}

std::vector<ActuatorDescription> read_actuators(const YamlNode& node, Diagnostics& found) {
  std::vector<ActuatorDescription> actuators;
  if (!check_mapping(node, "actuators", found)) {
    return actuators;
  }
  for (const YamlEntry& entry : node.entries) {
    if (auto actuator = read_actuator(entry, found)) {
      actuators.push_back(*std::move(actuator));
    }
  }
  return actuators;
}

}  // namespace kinestat
