// Mappings whose keys stand in another; to be included through format/mapping.hpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "format/mapping_key.hpp"

namespace kinestat {

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::group(const Mapping& part) {
  return group(
      part, [](auto& object) -> auto& { return object; });
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::group(Member T::*member, const Mapping<Member>& part) {
  return group(
      part, [member](auto& object) -> auto& { return object.*member; });
}

template <class T>
template <class Part, class Get>
typename Mapping<T>::Key& Mapping<T>::Key::group(const Mapping<Part>& part, Get get) {
  return by(
      part.shape(),
      [&part, get](const FileValue& value, T& object) { part.read_into(get(object), value); },
      [&part, get](const T& object) { return part.text_if_any(get(object)); });
}

template <class T>
template <class Item>
void Mapping<T>::one_or_several(const Mapping<Item>& item,
                                std::vector<Item> T::*member,
                                FormKey list_key,
                                std::string_view title,
                                std::string_view hint,
                                const Mapping<Item>* of_list) {
  SharedList<std::string_view> replaced;
  for (std::size_t i = 0; i < item.steps_.size(); ++i) {
    replaced.push_back(item.shape_.keys[i].key);
    shape_.keys.push_back(item.shape_.keys[i]);
    steps_.push_back({.read =
                          [&item, member, i](const FileValue& value, T& object) {
                            (object.*member).resize(1);
                            item.steps_[i].read(value, (object.*member).front());
                          },
                      .write =
                          [&item, member, i](const T& object) {
                            const std::vector<Item>& items = object.*member;
                            return items.size() == 1 ? item.steps_[i].write(items.front())
                                                     : std::nullopt;
                          }});
  }
  const auto list =
      list_of((of_list != nullptr ? *of_list : item).form(), std::string(title), std::string(hint));
  list_key.shape = list.shape;
  instead(list_key.key, std::move(replaced), hint);
  shape_.keys.push_back(std::move(list_key));
  steps_.push_back({.read =
                        [list, member](const FileValue& value, T& object) {
                          object.*member = list.read(value).value_or(std::vector<Item>{});
                        },
                    .write =
                        [list, member](const T& object) {
                          const std::vector<Item>& items = object.*member;
                          return items.size() > 1 ? std::optional(list.write(items)) : std::nullopt;
                        }});
}

}  // namespace kinestat
