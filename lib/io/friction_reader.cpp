#include "io/friction_reader.hpp"

#include <string>

#include "io/fields.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

std::optional<FrictionDescription> read_friction(const YamlNode& node,
                                                 std::string_view what,
                                                 Diagnostics& found) {
  const int errors_before = found.error_count();
  FrictionDescription friction;
  friction.where = node.where;
  if (node.kind == YamlKind::scalar) {
    friction.mu = read_value(node, what, found);
    return friction.mu ? std::optional(std::move(friction)) : std::nullopt;
  }
  Fields fields(node, node.where, std::string(what), found);
  const auto read = [&](std::string_view key) -> std::optional<Value> {
    const YamlNode* entry = fields.find(key);
    return entry == nullptr ? std::nullopt : read_value(*entry, key, found);
  };
  friction.mu = read("mu");
  friction.radius = read("radius");
  friction.length = read("length");
  friction.tau = read("tau");
  friction.c = read("c");
  fields.finish();
  return found.error_count() == errors_before ? std::optional(std::move(friction)) : std::nullopt;
}

}  // namespace kinestat
