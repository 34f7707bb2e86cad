#include "forms/worded.hpp"

#include <algorithm>

#include "forms/value_forms.hpp"
#include "io/fields.hpp"

namespace kinestat {

namespace {

// Whether every one of the mappings needs the key.
bool is_needed_by_all(const FormShape& shape, std::string_view key) {
  return std::ranges::all_of(shape.items, [key](const FormShape& one) {
    return std::ranges::any_of(
        one.keys, [key](const FormKey& each) { return each.is_needed && each.key == key; });
  });
}

void complain_of_no_word(const FileValue& value, const FormShape& shape) {
  Fields fields(value.node, value.where, value.what, value.found);
  for (const FormKey& key : shape.items.front()->keys) {
    if (is_needed_by_all(shape, key.key)) {
      (void)fields.require(key.key, std::string(key.missing));
    }
  }
  for (const FormShape& one : shape.items) {
    for (const FormKey& key : one.keys) {
      (void)fields.find(key.key);
    }
  }
  fields.finish();
}

}  // namespace

std::optional<std::size_t> find_worded(const FileValue& value,
                                       const FormShape& shape,
                                       const std::string& title) {
  const YamlNode* word = value.node.kind == YamlKind::mapping
                             ? value.node.find(shape.items.front()->keys.front().key)
                             : nullptr;
  if (word == nullptr) {
    complain_of_no_word(value, shape);
    return std::nullopt;
  }
  return read_word_of({.node = *word,
                       .what = title,
                       .owner = &value.what,
                       .where = word->where,
                       .place = word->where,
                       .space = value.space,
                       .found = value.found},
                      shape.words);
}

}  // namespace kinestat
