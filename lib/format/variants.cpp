#include "format/variants.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "io/field_values.hpp"

namespace kinestat {

namespace {

std::string_view first_key(const FormShape& mapping) {
  return mapping.keys.front().key;
}

// No first key, perhaps because the word is misspelt.
void complain_of_none(const FileValue& value, const FormShape& shape, const VariantTexts& texts) {
  std::vector<std::string> words;
  for (const FormShape& one : shape.items) {
    words.emplace_back(first_key(one));
  }
  for (const YamlEntry& entry : value.node.entries) {
    const std::string guess = did_you_mean(entry.key, words);
    if (!guess.empty()) {
      value.found.error("E0302",
                        entry.key_where,
                        fmt::format("{} has no key '{}'", value.what, entry.key),
                        fmt::format("{} {}", guess, texts.none_hint));
      return;
    }
  }
  value.found.error(
      "E0303", value.where, fmt::format(fmt::runtime(texts.none), value.what), texts.none_hint);
}

std::vector<std::size_t> variants_there(const FileValue& value, const FormShape& shape) {
  std::vector<std::size_t> there;
  for (std::size_t i = 0; i < shape.items.size(); ++i) {
    if (value.node.find(first_key(shape.items[i])) != nullptr) {
      there.push_back(i);
    }
  }
  return there;
}

}  // namespace

std::optional<std::size_t> find_variant(const FileValue& value,
                                        const FormShape& shape,
                                        const VariantTexts& texts) {
  if (value.node.kind != YamlKind::mapping) {
    Fields(value.node, value.where, value.what, value.found).finish();
    return std::nullopt;
  }
  const std::vector<std::size_t> there = variants_there(value, shape);
  if (there.size() == 1) {
    return there.front();
  }
  if (there.empty()) {
    complain_of_none(value, shape, texts);
  } else {
    value.found.error("E0302",
                      place_of_key(value.node, first_key(shape.items[there.front()])),
                      fmt::format(fmt::runtime(texts.both), value.what),
                      texts.both_hint);
  }
  return std::nullopt;
}

std::optional<std::size_t> find_only_variant(const FileValue& value,
                                             const FormShape& shape,
                                             const std::string& message,
                                             const std::string& hint) {
  Fields fields(value.node, value.where, value.what, value.found);
  if (value.node.kind != YamlKind::mapping) {
    return std::nullopt;
  }
  const std::vector<std::size_t> there = variants_there(value, shape);
  if (there.size() == 1) {
    return there.front();
  }
  value.found.error("E0303", value.where, fmt::format(fmt::runtime(message), value.what), hint);
  for (const FormShape& one : shape.items) {
    for (const FormKey& key : one.keys) {
      (void)fields.find(key.key);
    }
  }
  fields.finish();
  return std::nullopt;
}

}  // namespace kinestat
