#include "format/schema.hpp"

#include <string_view>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/version.hpp"
#include "format/internal/shape_schema.hpp"
#include "format/sections/sections.hpp"

namespace kinestat {

namespace {

constexpr const char* kDraft = "http://json-schema.org/draft-07/schema#";

// Lists of two and of three, if they are lists.
constexpr const char* kCounted = R"({
  "two": {"$comment": "A list of two, if it is a list.",
          "minItems": 2, "maxItems": 2, "doNotSuggest": true},
  "three": {"$comment": "A list of three, if it is a list.",
            "minItems": 3, "maxItems": 3, "doNotSuggest": true}})";

// How many components points and vectors have follows from the space.
constexpr const char* kComponents =
    R"({"if": {"properties": {"space": {"const": "planar"}}, "required": ["space"]},
        "then": {"$ref": "#/definitions/planar_components"},
        "else": {"$ref": "#/definitions/spatial_components"}})";

void add_components(const FormKey& key, Json& definitions) {
  for (const Space space : {Space::planar, Space::spatial}) {
    const Json components = components_schema(key.shape, space);
    const char* name = space == Space::planar ? "planar_components" : "spatial_components";
    definitions[name]["$comment"] =
        "How many components points and vectors have; what they are is said above.";
    if (!components.is_null()) {
      definitions[name]["properties"][std::string(key.key)] = components;
    }
  }
}

}  // namespace

std::string mechanism_schema() {
  const FormShape& file = file_sections().shape();
  ShapeSchema declared;
  Json schema = {{"$schema", kDraft},
                 {"title", fmt::format("kinestat mechanism, format {}", kFormatVersion)}};
  schema.update(declared.of_file(file));
  schema["allOf"].push_back(Json::parse(kComponents));
  Json definitions = Json::parse(kCounted);
  for (const FormKey& key : file.keys) {
    add_components(key, definitions);
  }
  for (const auto& [name, definition] : declared.definitions()) {
    KINESTAT_EXPECTS(!definitions.contains(name));
    definitions[name] = definition;
  }
  schema["definitions"] = definitions;
  return schema.dump(2) + "\n";
}

}  // namespace kinestat
