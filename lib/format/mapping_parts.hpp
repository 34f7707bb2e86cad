// The rarer parts of a declaration; to be included through format/mapping.hpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "format/mapping_key.hpp"

namespace kinestat {

template <class T>
Form<T> Mapping<T>::form() const {
  return {.shape = shape_,
          .read = [this](const FileValue& value) { return read(value); },
          .write =
              [this](const T& object) {
                FileText written = text(object);
                return shape_.may_be_empty && written.entries.empty() ? FileText() : written;
              }};
}

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::group(const Mapping& part) {
  key_.shape = part.shape_;
  add({.read = [&part](const FileValue& value, T& object) { part.read_into(object, value); },
       .write = [&part](const T& object) -> std::optional<FileText> {
         FileText text = part.text(object);
         return text.entries.empty() ? std::nullopt : std::optional(std::move(text));
       }});
  return *this;
}

template <class T>
template <class Read>
typename Mapping<T>::Key& Mapping<T>::Key::passed_over(const Form<Read>& form,
                                                       std::string_view example) {
  key_.shape = form.shape;
  key_.examples.push_back(example);
  add({.read = [read = form.read](const FileValue& value, T&) { (void)read(value); },
       .write = [](const T&) { return std::optional<FileText>(); }});
  return *this;
}

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::noted(bool T::*is_there) {
  Step& step = mapping_.steps_.back();
  step.read = [is_there, read = step.read](const FileValue& value, T& object) {
    object.*is_there = true;
    read(value, object);
  };
  step.write = [is_there, write = step.write](const T& object) {
    auto text = write(object);
    return text || !(object.*is_there) ? text
                                       : std::optional(FileText{.kind = FileText::Kind::mapping});
  };
  return *this;
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::selects(Member T::*member, Member chosen) {
  Step& step = mapping_.steps_.back();
  step.read = [member, chosen, read = step.read](const FileValue& value, T& object) {
    object.*member = chosen;
    read(value, object);
  };
  step.write = [member, chosen, write = step.write](const T& object) {
    return object.*member == chosen ? write(object) : std::nullopt;
  };
  return *this;
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::pair(Member T::*first,
                                                Member T::*second,
                                                const Form<Member>& form,
                                                std::string_view example,
                                                std::string_view hint) {
  const auto list = list_of(form, "", std::string(hint), {.least = 2, .most = 2});
  key_.shape = list.shape;
  key_.examples.push_back(example);
  key_.is_needed = true;
  add({.read =
           [first, second, list](const FileValue& value, T& object) {
             if (auto both = list.read(value)) {
               object.*first = std::move(both->front());
               object.*second = std::move(both->back());
             }
           },
       .write =
           [first, second, list](const T& object) {
             return std::optional(list.write({object.*first, object.*second}));
           }});
  return *this;
}

template <class T>
template <class Item>
void Mapping<T>::one_or_several(const Mapping<Item>& item,
                                std::vector<Item> T::*member,
                                FormKey list_key,
                                std::string_view title,
                                std::string_view hint) {
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
  const auto list = list_of(item.form(), std::string(title), std::string(hint));
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
