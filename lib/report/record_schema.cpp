#include "report/record_schema.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/version.hpp"
#include "record/measure_word.hpp"
#include "report/json_values.hpp"

namespace kinestat {

namespace {

Json schema_of(const Shape& shape, const std::string& meaning);

// Of what has no key of its own: an item of a list or a map.
std::string meaning_of(const Shape& item) {
  return item.form == Shape::Form::object ? item.record->meaning : "";
}

Json type_of(const std::string& type, bool is_nullable) {
  return is_nullable ? Json::array({type, "null"}) : Json(type);
}

void add_keys(const RecordShape& record, Json& schema) {
  schema["additionalProperties"] = false;
  schema["required"] = Json::array();
  schema["properties"] = Json::object();
  for (const Property& property : record.properties) {
    if (!property.is_in_reports) {
      continue;
    }
    if (!property.is_optional) {
      schema["required"].push_back(property.key);
    }
    schema["properties"][property.key] = schema_of(property.shape, property.meaning);
  }
}

void add_words(const Shape& shape, Json& schema) {
  schema["enum"] = shape.words;
  if (shape.is_nullable) {
    schema["enum"].push_back(nullptr);
  }
}

// The components of a vector may all measure the same.
void add_components(const Shape& shape, Json& schema) {
  const auto is_like_first = [&](const Shape& item) {
    return item.measure == shape.items.front().measure;
  };
  if (std::ranges::all_of(shape.items, is_like_first)) {
    schema["items"] = schema_of(shape.items.front(), "");
  } else {
    schema["items"] = Json::array();
    for (const Shape& item : shape.items) {
      schema["items"].push_back(schema_of(item, ""));
    }
  }
  schema["minItems"] = shape.items.size();
  schema["maxItems"] = shape.items.size();
}

void add_number(const Shape& shape, const char* type, Json& schema) {
  schema["type"] = type_of(type, shape.is_nullable);
  schema["measures"] = word_of(shape.measure);
  if (shape.least) {
    schema["minimum"] = *shape.least;
  }
  if (shape.may_be_by_name) {
    Shape one = shape;
    one.may_be_by_name = false;
    schema["type"] = Json::array({type, "null", "object"});
    schema["additionalProperties"] = schema_of(one, "Of one of several.");
  }
}

Json schema_of(const Shape& shape, const std::string& meaning) {
  Json schema = Json::object();
  if (!meaning.empty()) {
    schema["description"] = meaning;
  }
  switch (shape.form) {
    case Shape::Form::number:
      add_number(shape, "number", schema);
      break;
    case Shape::Form::whole:
      add_number(shape, "integer", schema);
      break;
    case Shape::Form::text:
      schema["type"] = type_of("string", shape.is_nullable);
      break;
    case Shape::Form::word:
      schema["type"] = type_of("string", shape.is_nullable);
      add_words(shape, schema);
      break;
    case Shape::Form::flag:
      schema["type"] = type_of("boolean", shape.is_nullable);
      break;
    case Shape::Form::object:
      schema["type"] = type_of("object", shape.is_nullable);
      add_keys(*shape.record, schema);
      break;
    case Shape::Form::map:
      schema["type"] = type_of("object", shape.is_nullable);
      if (!shape.words.empty()) {
        schema["propertyNames"]["enum"] = shape.words;
      }
      schema["additionalProperties"] =
          schema_of(shape.items.front(), meaning_of(shape.items.front()));
      break;
    case Shape::Form::list:
      schema["type"] = type_of("array", shape.is_nullable);
      schema["items"] = schema_of(shape.items.front(), meaning_of(shape.items.front()));
      break;
    case Shape::Form::tuple:
      schema["type"] = type_of("array", shape.is_nullable);
      add_components(shape, schema);
      break;
    case Shape::Form::cell:
      schema["type"] = Json::array({"number", "string", "null"});
      schema["measures"] = word_of(shape.measure);
      break;
  }
  return schema;
}

}  // namespace

std::string schema_text_of(std::string_view name, const RecordShape& record) {
  Shape whole;
  whole.form = Shape::Form::object;
  whole.record = &record;
  Json schema = Json::object();
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = fmt::format("kinestat {}, version {}", name, kReportVersion);
  schema.update(schema_of(whole, record.meaning));
  return schema.dump(2) + "\n";
}

}  // namespace kinestat
