// Mappings of which each has a key of its own: the first that it needs says which of them it is.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "format/mapping.hpp"

namespace kinestat {

/// What is said where none of the first keys is there, or several are; {} is the mapping.
struct VariantTexts {
  std::string none;
  std::string none_hint;
  std::string both;
  std::string both_hint;
};

/// The index of the mapping whose first key is there; empty after an error.
std::optional<std::size_t> find_variant(const FileValue& value,
                                        const FormShape& shape,
                                        const VariantTexts& texts);

/// One of the mappings; `choose` says in which of them a value is written.
template <class T>
Form<T> one_mapping_of(std::vector<const Mapping<T>*> mappings,
                       VariantTexts texts,
                       std::function<std::size_t(const T&)> choose) {
  FormShape shape{.kind = FormKind::variants};
  for (const Mapping<T>* mapping : mappings) {
    shape.items.push_back(mapping->shape());
  }
  return {
      .shape = shape,
      .read =
          [mappings, shape, texts = std::move(texts)](const FileValue& value) -> std::optional<T> {
        const auto index = find_variant(value, shape, texts);
        return index ? mappings[*index]->read(value) : std::nullopt;
      },
      .write = [mappings, choose](const T& value) { return mappings[choose(value)]->text(value); }};
}

}  // namespace kinestat
