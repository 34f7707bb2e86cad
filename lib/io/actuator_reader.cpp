#include "io/actuator_reader.hpp"

#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

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
