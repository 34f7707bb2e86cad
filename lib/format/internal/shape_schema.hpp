// Shapes as JSON Schema, with what editors show and offer.
#pragma once

#include <map>
#include <string>

#include "format/form_shape.hpp"
#include "format/internal/json.hpp"

namespace kinestat {

/// Writes the schemas of keys and collects the definitions that they refer to.
class ShapeSchema {
 public:
  /// Of a key of the file itself, whose mapping is a section.
  Json of_section(const FormKey& key);

  /// Those met so far, by name.
  const std::map<std::string, Json>& definitions() const { return definitions_; }

 private:
  Json of_key(const FormKey& key);
  Json in_place(const FormKey& key);
  Json of_item(const FormShape& shape);
  Json of_shape(const FormShape& shape);
  void add_values(const FormShape& shape, Json& schema);
  void add_mapping(const FormShape& shape, Json& schema);
  void add_variants(const FormShape& shape, Json& schema);
  void add_alternatives(const FormShape& shape, const Json& examples, Json& schema);
  void define(const FormShape& shape);

  std::map<std::string, Json> definitions_;
};

/// How many components the points and vectors of a key have in a space; null if it has none.
Json components_schema(const FormShape& shape, Space space);

}  // namespace kinestat
