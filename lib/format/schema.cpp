#include "format/schema.hpp"

#include <string_view>

#include "core/contract.hpp"
#include "format/embedded.hpp"
#include "format/internal/shape_schema.hpp"
#include "format/sections/sections.hpp"

namespace kinestat {

namespace {

// What stands in the kept part for a section that is declared.
constexpr std::string_view kDeclared = "declared";

void add_components(const FormKey& key, Json& schema) {
  for (const Space space : {Space::planar, Space::spatial}) {
    const Json components = components_schema(key.shape, space);
    const char* name = space == Space::planar ? "planar_components" : "spatial_components";
    if (!components.is_null()) {
      schema["definitions"][name]["properties"][std::string(key.key)] = components;
    }
  }
}

}  // namespace

std::string mechanism_schema() {
  Json schema = Json::parse(find_text(embedded_kept_schema(), "kept_schema")->text);
  ShapeSchema declared;
  for (const FormKey& key : file_sections().shape().keys) {
    KINESTAT_EXPECTS(schema["properties"][std::string(key.key)] == kDeclared);
    schema["properties"][std::string(key.key)] = declared.of_section(key);
    add_components(key, schema);
  }
  for (const auto& [name, definition] : declared.definitions()) {
    KINESTAT_EXPECTS(!schema["definitions"].contains(name));
    schema["definitions"][name] = definition;
  }
  return schema.dump(2) + "\n";
}

}  // namespace kinestat
