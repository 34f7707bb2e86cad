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

/// Whether there is exactly one of the first keys; if not, adds an error, and of keys that none of
/// the mappings has.
std::optional<std::size_t> find_only_variant(const FileValue& value,
                                             const FormShape& shape,
                                             const std::string& message,
                                             const std::string& hint);

/// One of the mappings, all of whose first keys count as known.
template <class T>
Form<T> only_one_of(std::vector<const Mapping<T>*> mappings,
                    std::string message,
                    std::string hint,
                    std::function<std::size_t(const T&)> choose) {
  auto form = one_mapping_of<T>(mappings, {}, std::move(choose));
  SharedList<std::string_view> known;
  for (const FormShape& one : form.shape.items) {
    known.push_back(one.keys.front().key);
  }
  form.read = [=, shape = form.shape](const FileValue& value) {
    const auto index = find_only_variant(value, shape, message, hint);
    return index ? mappings[*index]->read(value, known) : std::nullopt;
  };
  return form;
}

}  // namespace kinestat
