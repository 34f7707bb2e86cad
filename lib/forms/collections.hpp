// Forms that are put together from others: lists, and mappings of names.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "description/value.hpp"
#include "forms/any_member.hpp"
#include "forms/form.hpp"

namespace kinestat {

/// How many items a list has.
struct Count {
  std::size_t least = 1;
  std::size_t most = FormShape::kAnyNumber;
};

AnyForm any_list_of(const AnyForm& item,
                    const ListOps& list,
                    const std::string& title,
                    const std::string& hint,
                    Count count);

/// A list of so many items; without a hint a sketch says how to write it.
template <class T>
Form<std::vector<T>> list_of(const Form<T>& item,
                             const std::string& title,
                             const std::string& hint = {},
                             Count count = {}) {
  return form_of_a<std::vector<T>>(any_list_of(any_of(item), kListOps<T>, title, hint, count));
}

AnyForm any_one_or_more(const AnyForm& item,
                        const ListOps& list,
                        std::size_t least,
                        const std::string& hint);

/// One item, or a list of them.
template <class T>
Form<std::vector<T>> one_or_more(const Form<T>& item,
                                 std::size_t least = 0,
                                 const std::string& hint = {}) {
  return form_of_a<std::vector<T>>(any_one_or_more(any_of(item), kListOps<T>, least, hint));
}

/// The members of an element of a mapping of names.
struct ElementMembers {
  AnyMember name;  ///< a Name, or an optional one
  bool has_optional_name = false;
  std::optional<AnyMember> value;  ///< empty: the element itself is the value
};

AnyForm any_by_name(const ElementMembers& members,
                    const AnyForm& value,
                    const ListOps& list,
                    FormShape shape,
                    const std::string& title);

/// A mapping of names to descriptions: "load '{0}'". `shape` says what an element and its name are.
template <class T>
Form<std::vector<T>> named(Name T::*name,
                           const Form<T>& element,
                           const FormShape& shape,
                           const std::string& title) {
  return form_of_a<std::vector<T>>(
      any_by_name({.name = name, .value = {}}, any_of(element), kListOps<T>, shape, title));
}

/// A mapping of names to single values.
template <class T, class Value, class NameMember>
Form<std::vector<T>> values_by_name(NameMember T::*name,
                                    Value T::*value,
                                    const Form<Value>& form,
                                    const FormShape& shape,
                                    const std::string& title) {
  return form_of_a<std::vector<T>>(
      any_by_name({.name = name,
                   .has_optional_name = std::is_same_v<NameMember, std::optional<Name>>,
                   .value = value},
                  any_of(form),
                  kListOps<T>,
                  shape,
                  title));
}

}  // namespace kinestat
