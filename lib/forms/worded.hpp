// Mappings of which a word behind a key says which one it is: {type: revolute, …}.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "forms/mapping.hpp"

namespace kinestat {

/// The index of the mapping whose word stands behind the first key of all of them; empty after an
/// error. `title` is what the word is called in messages. Where the key is missing, the keys of all
/// mappings count as known, and none is read.
std::optional<std::size_t> find_worded(const FileValue& value,
                                       const FormShape& shape,
                                       const std::string& title);

/// One of the mappings, each with its word; the first key of all chooses. `which` answers in which
/// of them a value is written.
template <class T>
Form<T> chosen_by_word(std::vector<Lazy<Mapping<T>>> mappings,
                       SharedList<Word> words,
                       std::string title,
                       std::function<std::size_t(const T&)> which) {
  FormShape shape{.kind = FormKind::by_word, .words = std::move(words)};
  for (const Lazy<Mapping<T>>& mapping : mappings) {
    shape.items.push_back(Lazy<FormShape>([mapping] { return mapping->shape(); }));
  }
  const AnyRead read = [mappings, shape, title](const FileValue& value, void* object) {
    const auto index = find_worded(value, shape, title);
    return index && mappings[*index]->any_read(object, value);
  };
  return {.shape = shape, .read = read, .write = [mappings, which](const T& one) {
            return mappings[which(one)]->text(one);
          }};
}

}  // namespace kinestat
