// Keys whose values are members; to be included through format/mapping.hpp.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "format/lazy.hpp"
#include "format/mapping_key.hpp"

namespace kinestat {

template <class T>
const Form<T>& form_of(const Form<T>& form) {
  return form;
}

template <class T>
Form<T> form_of(const Mapping<T>& mapping) {
  return mapping.form();
}

template <class T>
template <class Member, class Read>
typename Mapping<T>::Key& Mapping<T>::Key::may(Member T::*member,
                                               const Form<Read>& form,
                                               std::string_view example) {
  return kept(member, form.shape, form.read, form.write, example);
}

template <class T>
template <class Member, std::invocable Make>
typename Mapping<T>::Key& Mapping<T>::Key::may(Member T::*member,
                                               Make make,
                                               std::string_view example) {
  const Lazy form([make] { return form_of(make()); });
  return kept(
      member,
      Lazy<FormShape>([form] { return form->shape; }),
      [form](const FileValue& value) { return form->read(value); },
      [form](const auto& value) { return form->write(value); },
      example);
}

template <class T>
template <class Member, class Read, class Write>
typename Mapping<T>::Key& Mapping<T>::Key::kept(
    Member T::*member, Lazy<FormShape> shape, Read read, Write write, std::string_view example) {
  const bool is_needed = key_.is_needed;
  return by(
      std::move(shape),
      [member, read](const FileValue& value, T& object) {
        if (auto one = read(value)) {
          set_member(object.*member, *std::move(one));
        }
      },
      [member, write, is_needed](const T& object) -> std::optional<FileText> {
        const auto* one = present(object.*member, T{}.*member, is_needed);
        return one != nullptr ? std::optional(write(*one)) : std::nullopt;
      },
      example);
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::pair(Member T::*first,
                                                Member T::*second,
                                                const Form<Member>& form,
                                                std::string_view example,
                                                std::string_view hint) {
  return pair(
      first, second, list_of(form, "", std::string(hint), {.least = 2, .most = 2}), example);
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::pair(Member T::*first,
                                                Member T::*second,
                                                const Form<std::vector<Member>>& list,
                                                std::string_view example) {
  key_.is_needed = true;
  return by(
      list.shape,
      [first, second, list](const FileValue& value, T& object) {
        if (auto both = list.read(value)) {
          object.*first = std::move(both->front());
          object.*second = std::move(both->back());
        }
      },
      [first, second, list](const T& object) {
        return std::optional(list.write({object.*first, object.*second}));
      },
      example);
}

}  // namespace kinestat
