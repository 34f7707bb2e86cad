// The rarer parts of a declaration; to be included through forms/mapping.hpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "forms/mapping_key.hpp"

namespace kinestat {

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
      [first, second, read = list.read](const FileValue& value, T& object) {
        if (auto both = read(value)) {
          object.*first = std::move(both->front());
          object.*second = std::move(both->back());
        }
      },
      [first, second, write = list.write](const T& object) {
        return std::optional(write({object.*first, object.*second}));
      },
      example);
}

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::group(const Mapping& part) {
  mapping_.add_group(std::move(key_), part, std::nullopt);
  return *this;
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::group(Member T::*member, const Mapping<Member>& part) {
  mapping_.add_group(std::move(key_), part, member);
  return *this;
}

template <class T>
template <class Value>
typename Mapping<T>::Key& Mapping<T>::Key::passed_over(const Form<Value>& form,
                                                       std::string_view example,
                                                       std::optional<Value> written) {
  mapping_.add(
      with(form.shape, example),
      [read = form.read](const FileValue& value, void*) { (void)read(value); },
      [write = form.write, written](const void*) {
        return written ? std::optional(write(*written)) : std::nullopt;
      });
  return *this;
}

template <class T>
typename Mapping<T>::Key& Mapping<T>::Key::by(
    Lazy<FormShape> shape,
    std::function<void(const FileValue&, T&)> read,
    std::function<std::optional<FileText>(const T&)> write,
    std::string_view example) {
  mapping_.add(
      with(std::move(shape), example),
      [read = std::move(read)](const FileValue& value, void* object) {
        read(value, *static_cast<T*>(object));
      },
      [write = std::move(write)](const void* object) {
        return write(*static_cast<const T*>(object));
      });
  return *this;
}

template <class T>
template <class Member>
typename Mapping<T>::Key& Mapping<T>::Key::selects(Member T::*member, Member chosen) {
  const AnyMember any = member;
  mapping_.also_read(
      [any, chosen](void* object) { *static_cast<Member*>(any.of(object)) = chosen; });
  mapping_.write_only_if([any, chosen](const void* object) {
    return *static_cast<const Member*>(any.of(object)) == chosen;
  });
  return *this;
}

template <class T>
template <class Member, class Value>
typename Mapping<T>::Key& Mapping<T>::Key::may_lazily(Member T::*member,
                                                      const Lazy<Form<Value>>& form,
                                                      std::string_view example) {
  mapping_.add_member(
      with(Lazy<FormShape>([form] { return form->shape; }), example),
      member,
      kMemberOps<Member, Value>,
      [form](const FileValue& value, void* object) { return form->read.any()(value, object); },
      [form](const void* object) { return form->write.any()(object); });
  return *this;
}

}  // namespace kinestat
