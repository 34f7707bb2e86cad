#include "format/internal/shape_schema.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "format/internal/example_json.hpp"
#include "format/internal/json_types.hpp"
#include "format/internal/rule_schema.hpp"
#include "format/internal/snippets.hpp"
#include "format/internal/worded_schema.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kExpression = R"json({
  "$comment": "What every number may be: a YAML number, or an expression of numbers, units, parameters and functions. 017, 0x1F and .nan are refused by the program only, as a schema does not see how a number is written.",
  "type": ["number", "string"],
  "pattern": "^(?!\\s*$|\\s*[-+]?\\d+,)",
  "patternErrorMessage": "Write a number, with a decimal point, or an expression such as (N1 + N2)/2*module."
})json";

void add_range(const NumberRange& range, Json& schema) {
  const auto add = [&schema](const char* key, const std::optional<double>& bound) {
    if (bound) {
      const auto whole = static_cast<long>(*bound);
      schema[key] = *bound == static_cast<double>(whole) ? Json(whole) : Json(*bound);
    }
  };
  add("minimum", range.least);
  add("maximum", range.most);
  add("exclusiveMinimum", range.above);
  add("exclusiveMaximum", range.below);
  if (range.is_whole) {
    schema["multipleOf"] = 1;
  }
  if (range.is_not_zero) {
    schema["if"] = {{"const", 0}};
    schema["then"] = {{"type", "string"}, {"errorMessage", "Write a number other than 0."}};
  }
}

void add_words(const SharedList<Word>& words, Json& schema) {
  schema["type"] = "string";
  schema["enum"] = Json::array();
  schema["enumDescriptions"] = Json::array();
  for (const Word& word : words) {
    schema["enum"].push_back(std::string(word.text));
    schema["enumDescriptions"].push_back(std::string(word.meaning));
  }
}

void add_count(const FormShape& shape, Json& schema) {
  if (shape.least > 0) {
    schema["minItems"] = shape.least;
  }
  if (shape.most != FormShape::kAnyNumber) {
    schema["maxItems"] = shape.most;
  }
}

Json reference(std::string_view definition) {
  return {{"$ref", fmt::format("#/definitions/{}", definition)}};
}

Json examples_json(const SharedList<std::string_view>& texts) {
  Json examples = Json::array();
  for (const std::string_view text : texts) {
    examples.push_back(example_json(std::string(text)));
  }
  return examples;
}

// A mapping of such names alone is something else.
void refuse_foreign(const ForeignNames& foreign, Json& schema) {
  if (foreign.names.empty()) {
    return;
  }
  Json names = Json::array();
  for (const std::string_view name : foreign.names) {
    names.push_back(std::string(name));
  }
  const Json refused = {{"type", "array"}, {"errorMessage", std::string(foreign.instead)}};
  schema = {{"if", {{"propertyNames", {{"enum", names}}}}}, {"then", refused}, {"else", schema}};
}

// A number about z, or a vector.
FormShape couple_alternatives(const FormShape& couple) {
  const FormShape& moment = couple.items.front();
  const FormShape vector{.kind = FormKind::list, .least = 3, .most = 3, .items = {moment}};
  return {.kind = FormKind::by_shape, .items = {moment, vector}};
}

}  // namespace

void ShapeSchema::define(const FormShape& shape) {
  const std::string name(shape.definition);
  const bool has_content = !shape.meaning.empty() || shape.kind == FormKind::mapping;
  if (shape.definition.empty() || !has_content || definitions_.contains(name)) {
    return;
  }
  definitions_[name];  // it may refer to itself
  definitions_[name] = of_shape(shape);
}

// A whole schema of its own.
Json ShapeSchema::of_shape(const FormShape& shape) {
  return in_place({.meaning = shape.meaning, .shape = shape, .examples = shape.examples});
}

Json ShapeSchema::of_item(const FormShape& shape) {
  if (shape.definition.empty()) {
    return of_shape(shape);
  }
  define(shape);
  return reference(shape.definition);
}

Json ShapeSchema::of_key(const FormKey& key) {
  if (key.shape->definition.empty()) {
    return in_place(key);
  }
  Json schema = of_item(key.shape);
  if (!key.meaning.empty()) {
    schema["description"] = std::string(key.meaning);
  }
  if (!key.usual.empty()) {
    schema["default"] = example_json(std::string(key.usual));
  }
  if (!key.examples.empty()) {
    schema["examples"] = examples_json(key.examples);
  }
  return schema;
}

// What may be said of a list or mapping, apart from what it is.
void ShapeSchema::add_values(const FormShape& shape, Json& schema) {
  switch (shape.kind) {
    case FormKind::vector:
      schema["items"] = of_item(shape.items.front());
      schema["minItems"] = 2;
      schema["maxItems"] = 3;
      break;
    case FormKind::list:
      schema["items"] = of_item(shape.items.front());
      add_count(shape, schema);
      add_rules(shape, schema);
      break;
    case FormKind::names:
      if (!shape.name_definition.empty()) {
        schema["propertyNames"] = of_item(text_shape(shape.name_definition));
      }
      if (shape.least > 0) {
        schema["minProperties"] = shape.least;
      }
      if (shape.most != FormShape::kAnyNumber) {
        schema["maxProperties"] = shape.most;
      }
      schema["additionalProperties"] = of_item(shape.items.front());
      refuse_foreign(shape.foreign, schema);
      break;
    case FormKind::mapping:
      add_mapping(shape, schema);
      break;
    case FormKind::variants:
      add_variants(shape, schema);
      break;
    case FormKind::by_word:
      add_worded(shape, schema);
      break;
    case FormKind::word:
      add_words(shape.words, schema);
      break;
    default:
      break;
  }
}

void ShapeSchema::add_mapping(const FormShape& shape, Json& schema, OfKey of) {
  schema["additionalProperties"] = false;
  Json needed = Json::array();
  Json properties = Json::object();
  for (const FormKey& key : shape.keys) {
    properties[std::string(key.key)] = (this->*of)(key);
    if (key.is_needed && !is_replaceable(shape, key.key)) {
      needed.push_back(std::string(key.key));
    }
  }
  if (!needed.empty()) {
    schema["required"] = needed;
  }
  schema["properties"] = properties;
  for (const FormKey& own : shape.beginnings) {
    schema["patternProperties"]["^" + std::string(own.key)] = {
        {"description", std::string(own.meaning)}, {"examples", examples_json(own.examples)}};
  }
  add_rules(shape, schema);
}

// Of each item.
std::vector<Json> ShapeSchema::mappings_of(const FormShape& shape) {
  std::vector<Json> mappings(shape.items.size(), Json::object());
  for (std::size_t i = 0; i < mappings.size(); ++i) {
    add_mapping(shape.items[i], mappings[i]);
  }
  return mappings;
}

// All keys of the mappings; the first key of each says which of them may stand.
void ShapeSchema::add_variants(const FormShape& shape, Json& schema) {
  std::vector<Json> mappings = mappings_of(shape);
  Json properties = Json::object();
  for (const Json& mapping : mappings) {
    for (const auto& [key, value] : mapping["properties"].items()) {
      if (!properties.contains(key)) {
        properties[key] = value;
      }
    }
  }
  schema["additionalProperties"] = false;
  schema["properties"] = properties;
  SharedList<std::string_view> firsts;
  for (std::size_t i = 0; i < mappings.size(); ++i) {
    Json& mapping = mappings[i];
    const std::string_view own = shape.items[i]->keys.front().key;
    const Json first = {{"required", Json::array({std::string(own)})}};
    Json refused = Json::object();
    for (const auto& [key, value] : properties.items()) {
      if (!mapping["properties"].contains(key)) {
        refused[key] = false;
      }
    }
    mapping["properties"] = refused;
    mapping.erase("additionalProperties");
    firsts.push_back(own);
    schema["allOf"].push_back({{"if", first}, {"then", mapping}});
  }
  add_any_of(firsts, schema);
}

// What all need stands first, then under each word what it may have beside. What is the same of
// several words is written once, in a definition.
void ShapeSchema::add_worded(const FormShape& shape, Json& schema) {
  std::vector<Json> mappings = mappings_of(shape);
  const Json needed = needed_by_all(mappings);
  schema["required"] = needed;
  for (const Json& key : needed) {
    schema["properties"][key.get<std::string>()] =
        mappings.front()["properties"][key.get<std::string>()];
  }
  for (Json& mapping : mappings) {
    settle(mapping, needed);
  }
  const std::string definition = fmt::format("{}_keys", shape.definition);
  definitions_[definition] = share_keys(shape, mappings, definition);
  const std::string chooser(shape.items.front()->keys.front().key);
  for (std::size_t i = 0; i < mappings.size(); ++i) {
    schema["allOf"].push_back(
        {{"if", has_word(chooser, shape.words[i].text)}, {"then", mappings[i]}});
  }
}

// The alternatives after the first condition that holds; the last needs none.
void ShapeSchema::add_alternatives(const FormShape& shape, const Json& examples, Json& schema) {
  std::vector<FormShape> ordered(shape.items.begin(), shape.items.end());
  std::stable_partition(ordered.begin(), ordered.end(), is_collection);
  Json* at = &schema;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    const FormShape& one = ordered[i];
    Json branch = Json::object();
    if (!one.definition.empty()) {
      branch = of_item(one);
    } else {
      add_values(one, branch);
      for (const Json& example : examples) {
        if (is_collection(one) && fits(one, example)) {
          branch["examples"].push_back(example);
        }
      }
    }
    if (i + 1 < ordered.size()) {
      (*at)["if"] = {{"type", types_of(one)}};
      (*at)["then"] = branch;
      (*at)["else"] = Json::object();
      at = &(*at)["else"];
    } else {
      *at = at == &schema ? schema : branch;
    }
  }
}

Json ShapeSchema::in_place(const FormKey& key) {
  if (key.shape->kind == FormKind::couple) {
    FormKey alternatives = key;
    alternatives.shape = couple_alternatives(key.shape);
    return in_place(alternatives);
  }
  const FormShape& shape = key.shape;
  const Json examples = examples_json(key.examples);
  Json schema = Json::object();
  if (!key.meaning.empty()) {
    schema["description"] = std::string(key.meaning);
  }
  if (shape.kind == FormKind::number) {
    definitions_.try_emplace("expression", Json::parse(kExpression));
    Json number = {{"allOf", Json::array({reference("expression")})}};
    add_range(shape.range, number);
    if (!shape.words.empty()) {
      number = {{"if", {{"const", std::string(shape.words.front().text)}}}, {"else", number}};
    }
    schema.update(number);
  } else if (shape.kind == FormKind::constant) {
    const std::string constant(shape.sketch);
    for (const Json& one : {example_json(constant), Json(constant)}) {  // in quotes, too
      schema["anyOf"].push_back({{"const", one}});
    }
  } else {
    schema["type"] = types_of(shape);
  }
  if (shape.kind == FormKind::word) {
    add_values(shape, schema);
  }
  if (!shape.pattern.empty()) {
    schema["pattern"] = std::string(shape.pattern);
    schema["patternErrorMessage"] = std::string(shape.pattern_text);
  }
  Json snippets = Json::array();
  if (shape.kind == FormKind::by_shape) {
    add_alternatives(shape, examples, schema);
    for (const FormShape& one : shape.items) {
      for (const Json& offered : is_collection(one) ? snippets_of(one, examples) : Json::array()) {
        snippets.push_back(offered);
      }
    }
  } else if (is_collection(shape)) {
    // An editor offers the snippets where nothing stands yet, and keys within what is there.
    schema["if"] = {{"type", types_of(shape)}};
    Json inside = Json::object();
    add_values(shape, inside);
    if (!examples.empty()) {
      inside["examples"] = examples;
    }
    schema["then"] = inside;
    snippets = snippets_of(shape, examples);
  }
  if (!key.usual.empty()) {
    schema["default"] = example_json(std::string(key.usual));
  }
  for (const Json& example : examples) {
    if (!is_collection(shape) && !example.is_array() && !example.is_object()) {
      schema["examples"].push_back(example);
    }
  }
  const bool is_list = types_of(shape).dump().find("array") != std::string::npos;
  for (const FormShape& one : shape.items) {
    for (const Word& word : shape.kind == FormKind::by_shape ? one.words : SharedList<Word>()) {
      snippets.push_back(snippet(word.text, std::string(word.text), word.meaning));
    }
  }
  for (const Suggestion& one : key.suggestions) {
    snippets.push_back(snippet(
        one.value, is_list ? fmt::format("[{}]", one.value) : std::string(one.value), one.meaning));
  }
  if (!snippets.empty()) {
    schema["defaultSnippets"] = snippets;
  }
  return schema;
}

Json ShapeSchema::of_section(const FormKey& key) {
  FormKey section = key;
  if (key.shape->kind == FormKind::mapping) {
    section.examples = key.shape->examples;
  }
  Json schema = of_key(section);
  if (key.shape->kind == FormKind::mapping) {
    schema["title"] = std::string(key.key);
    schema["defaultSnippets"] = Json::array({snippet(
        "the section", line_snippet(example_json(std::string(section.examples.front()))))});
  }
  return schema;
}

Json ShapeSchema::of_file(const FormShape& shape) {
  Json schema = {{"description", std::string(shape.meaning)}, {"type", "object"}};
  add_mapping(shape, schema, &ShapeSchema::of_section);
  return schema;
}

namespace {

// A reference hides what stands beside it.
Json without_reference(const Json& components, Space space) {
  const int count = space == Space::planar ? 2 : 3;
  return components.contains("$ref") ? Json{{"minItems", count}, {"maxItems", count}} : components;
}

}  // namespace

Json components_schema(const FormShape& shape, Space space) {
  const bool is_planar = space == Space::planar;
  if (shape.kind == FormKind::by_word) {
    std::vector<Json> components;
    for (const FormShape& one : shape.items) {
      components.push_back(components_schema(one, space));
    }
    Json schema = worded_counts(shape, components);
    schema["doNotSuggest"] = true;
    return schema;
  }
  if (shape.kind == FormKind::vector) {
    return {{"$ref", is_planar ? "#/definitions/two" : "#/definitions/three"}};
  }
  Json schema = Json::object();
  if (shape.kind == FormKind::couple) {
    schema["type"] = is_planar ? Json::array({"number", "string"}) : Json("array");
  }
  for (const FormShape& item : shape.items) {
    const Json inside = components_schema(item, space);
    if (inside.is_null()) {
      continue;
    }
    if (shape.kind == FormKind::by_shape || shape.kind == FormKind::variants) {
      schema.update(without_reference(inside, space), true);
    } else {
      schema[shape.kind == FormKind::list ? "items" : "additionalProperties"] = inside;
    }
  }
  for (const FormKey& key : shape.keys) {
    const Json inside = components_schema(key.shape, space);
    if (!inside.is_null()) {
      schema["properties"][std::string(key.key)] = inside;
    }
  }
  if (schema.empty()) {
    return nullptr;
  }
  schema["doNotSuggest"] = true;
  return schema;
}

}  // namespace kinestat
