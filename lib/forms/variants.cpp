#include "forms/variants.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "io/field_values.hpp"
#include "io/fields.hpp"

namespace kinestat {

namespace {

using Mappings = std::vector<const AnyMapping*>;

std::string_view first_key(const AnyMapping& mapping) {
  return mapping.shape().keys.front().key;
}

// No first key, perhaps because the word is misspelt.
void complain_of_none(const FileValue& value, const Mappings& mappings, const VariantTexts& texts) {
  std::vector<std::string> words;
  for (const AnyMapping* one : mappings) {
    words.emplace_back(first_key(*one));
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

std::vector<std::size_t> variants_there(const FileValue& value, const Mappings& mappings) {
  std::vector<std::size_t> there;
  for (std::size_t i = 0; i < mappings.size(); ++i) {
    if (value.node.find(first_key(*mappings[i])) != nullptr) {
      there.push_back(i);
    }
  }
  return there;
}

// The index of the mapping whose first key is there; empty after an error.
std::optional<std::size_t> find_variant(const FileValue& value,
                                        const Mappings& mappings,
                                        const VariantTexts& texts) {
  if (value.node.kind != YamlKind::mapping) {
    Fields(value.node, value.where, value.what, value.found).finish();
    return std::nullopt;
  }
  const std::vector<std::size_t> there = variants_there(value, mappings);
  if (there.size() == 1) {
    return there.front();
  }
  if (there.empty()) {
    complain_of_none(value, mappings, texts);
  } else {
    value.found.error("E0302",
                      place_of_key(value.node, first_key(*mappings[there.front()])),
                      fmt::format(fmt::runtime(texts.both), value.what),
                      texts.both_hint);
  }
  return std::nullopt;
}

// Likewise, of mappings all of whose first keys count as known.
std::optional<std::size_t> find_only_variant(const FileValue& value,
                                             const Mappings& mappings,
                                             const std::string& message,
                                             const std::string& hint) {
  Fields fields(value.node, value.where, value.what, value.found);
  if (value.node.kind != YamlKind::mapping) {
    return std::nullopt;
  }
  const std::vector<std::size_t> there = variants_there(value, mappings);
  if (there.size() == 1) {
    return there.front();
  }
  value.found.error("E0303", value.where, fmt::format(fmt::runtime(message), value.what), hint);
  for (const AnyMapping* one : mappings) {
    for (const FormKey& key : one->shape().keys) {
      (void)fields.find(key.key);
    }
  }
  fields.finish();
  return std::nullopt;
}

// All of them are written alike.
AnyForm form_of_all(const Mappings& mappings, AnyRead read, AnyChoice choose) {
  FormShape shape{.kind = FormKind::variants};
  for (const AnyMapping* mapping : mappings) {
    shape.items.push_back(mapping->shape());
  }
  return {.shape = std::move(shape),
          .read = std::move(read),
          .write = [mappings, choose = std::move(choose)](const void* object) {
            return mappings[choose(object)]->any_text(object);
          }};
}

}  // namespace

AnyForm any_mapping_of(std::vector<const AnyMapping*> mappings,
                       VariantTexts texts,
                       AnyChoice choose) {
  return form_of_all(
      mappings,
      [mappings, texts = std::move(texts)](const FileValue& value, void* object) {
        const auto index = find_variant(value, mappings, texts);
        return index && mappings[*index]->any_read(object, value);
      },
      std::move(choose));
}

AnyForm only_any_of(std::vector<const AnyMapping*> mappings,
                    std::string message,
                    std::string hint,
                    AnyChoice choose) {
  SharedList<std::string_view> known;
  for (const AnyMapping* mapping : mappings) {
    known.push_back(first_key(*mapping));
  }
  return form_of_all(
      mappings,
      [mappings, message = std::move(message), hint = std::move(hint), known](
          const FileValue& value, void* object) {
        const auto index = find_only_variant(value, mappings, message, hint);
        return index && mappings[*index]->any_read(object, value, known);
      },
      std::move(choose));
}

}  // namespace kinestat
