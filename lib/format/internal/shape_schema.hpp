// Shapes as JSON Schema, with what editors show and offer.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "format/internal/json.hpp"
#include "forms/form_shape.hpp"

namespace kinestat {

/// Writes the schemas of keys and collects the definitions that they refer to.
class ShapeSchema {
 public:
  /// Of the file itself, whose mappings are sections.
  Json of_file(const FormShape& shape);

  /// Those met so far, by name.
  const std::map<std::string, Json>& definitions() const { return definitions_; }

 private:
  using OfKey = Json (ShapeSchema::*)(const FormKey& key);

  Json of_section(const FormKey& key);
  Json of_key(const FormKey& key);
  Json in_place(const FormKey& key);
  Json of_item(const FormShape& shape);
  Json of_shape(const FormShape& shape);
  void add_values(const FormShape& shape, Json& schema);
  void add_mapping(const FormShape& shape, Json& schema, OfKey of = &ShapeSchema::of_key);
  std::vector<Json> mappings_of(const FormShape& shape);
  void add_variants(const FormShape& shape, Json& schema);
  void add_worded(const FormShape& shape, Json& schema);
  void add_alternatives(const FormShape& shape, const Json& examples, Json& schema);
  void define(const FormShape& shape);

  std::map<std::string, Json> definitions_;
};

/// How many components the points and vectors of a key have in a space; null if it has none.
Json components_schema(const FormShape& shape, Space space);

}  // namespace kinestat
