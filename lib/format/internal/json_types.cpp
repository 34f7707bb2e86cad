#include "format/internal/json_types.hpp"

#include <algorithm>

namespace kinestat {

Json types_of(const FormShape& shape) {
  switch (shape.kind) {
    case FormKind::number:
    case FormKind::constant:
      return Json::array({"number", "string"});
    case FormKind::text:
      return Json::array({"string", "number"});
    case FormKind::name:
    case FormKind::word:
    case FormKind::literal:
      return "string";
    case FormKind::flag:
      return "boolean";
    case FormKind::vector:
    case FormKind::list:
      return "array";
    case FormKind::couple:
      return Json::array({"array", "number", "string"});
    case FormKind::names:
    case FormKind::variants:
    case FormKind::by_word:
    case FormKind::mapping:
      return shape.may_be_empty ? Json::array({"object", "null"}) : Json("object");
    case FormKind::by_shape: {
      Json types = Json::array();
      for (const FormShape& one : shape.items) {
        const Json type = types_of(one);
        for (const Json& word : type.is_array() ? type : Json::array({type})) {
          if (std::ranges::find(types, word) == types.end()) {
            types.push_back(word);
          }
        }
      }
      return types;
    }
  }
  return {};
}

bool is_collection(const FormShape& shape) {
  const Json types = types_of(shape);
  return types == "array" || types == "object" || shape.may_be_empty;
}

}  // namespace kinestat
