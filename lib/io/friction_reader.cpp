#include "io/friction_reader.hpp"

#include <string>

#include <fmt/format.h>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

std::optional<FrictionDescription> read_friction(const YamlNode& node,
                                                 FrictionKind kind,
                                                 std::string_view what,
                                                 Diagnostics& found) {
  using enum FrictionKind;
  const int errors_before = found.error_count();
  FrictionDescription friction;
  friction.where = node.where;
  const bool turns = kind == journal || kind == thread;
  if (node.kind == YamlKind::scalar && !turns) {
    friction.mu = read_value(node, what, found);
    return friction.mu ? std::optional(std::move(friction)) : std::nullopt;
  }
  if (node.kind == YamlKind::scalar) {
    found.error("E0304",
                node.where,
                fmt::format("{} must be a mapping, as it needs a radius", what),
                "write friction: {mu: 0.1, radius: 12 mm}: of the journal, or the mean one of the "
                "thread");
    return std::nullopt;
  }
  Fields fields(node, node.where, std::string(what), found);
  const auto read = [&](std::string_view key) -> std::optional<Value> {
    const YamlNode* entry = fields.find(key);
    return entry == nullptr ? std::nullopt : read_value(*entry, key, found);
  };
  friction.mu = read("mu");
  if (kind != sliding) {
    const bool needs_radius = turns && friction.mu;
    const YamlNode* radius = needs_radius ? fields.require("radius") : fields.find("radius");
    friction.radius = radius == nullptr ? std::nullopt : read_value(*radius, "radius", found);
  }
  if (turns || kind == whatever) {
    friction.tau = read("tau");
  }
  if (kind == journal || kind == whatever) {
    friction.thrust_radius = read("thrust_radius");
  }
  if (kind == journal || kind == guide || kind == whatever) {
    friction.length = read("length");
  }
  if (kind != sliding) {
    friction.c = read("c");
  }
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(friction)) : std::nullopt;
}

}  // namespace kinestat
