// Forms that are put together from others: lists, and mappings of names.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "format/form.hpp"
#include "format/parts.hpp"

namespace kinestat {

/// How many items a list has.
struct Count {
  std::size_t least = 1;
  std::size_t most = FormShape::kAnyNumber;
};

/// A list of so many items; without a hint a sketch says how to write it.
template <class T>
Form<std::vector<T>> list_of(const Form<T>& item,
                             const std::string& title,
                             const std::string& hint = {},
                             Count count = {}) {
  const FormShape shape{
      .kind = FormKind::list, .least = count.least, .most = count.most, .items = {item.shape}};
  return {
      .shape = shape,
      .read = [shape, item, title, hint](const FileValue& value) -> std::optional<std::vector<T>> {
        if (!check_items(value, shape, hint)) {
          return std::nullopt;
        }
        std::vector<T> items;
        for (std::size_t i = 0; i < value.node.items.size(); ++i) {
          if (auto one = item.read(item_of(value, i, title))) {
            items.push_back(*std::move(one));
          }
        }
        const bool is_whole = items.size() == value.node.items.size();
        return is_whole ? std::optional(std::move(items)) : std::nullopt;
      },
      .write =
          [item](const std::vector<T>& items) {
            std::vector<FileText> texts;
            for (const T& one : items) {
              texts.push_back(item.write(one));
            }
            return list_text(std::move(texts));
          }};
}

/// One item, or a list of them.
template <class T>
Form<std::vector<T>> one_or_more(const Form<T>& item,
                                 std::size_t least = 0,
                                 const std::string& hint = {}) {
  const auto list = list_of(item, "", hint, {.least = least});
  return {.shape = {.kind = FormKind::by_shape, .items = {item.shape, list.shape}},
          .read = [item, list](const FileValue& value) -> std::optional<std::vector<T>> {
            if (value.node.kind == YamlKind::sequence) {
              return list.read(value);
            }
            auto one = item.read(value);
            return one ? std::optional(std::vector<T>{*std::move(one)}) : std::nullopt;
          },
          .write = list.write};
}

/// A mapping of names to values: each element has its name in `name` and takes its value by `set`;
/// `get` answers the value to be written. `shape` says what an element and its name are.
template <class T, class NameMember, class Read, class Set, class Get>
Form<std::vector<T>> by_name(NameMember T::*name,
                             const Form<Read>& element,
                             FormShape shape,
                             const std::string& title,
                             Set set,
                             Get get) {
  shape.kind = FormKind::names;
  shape.items = {element.shape};
  return {.shape = shape,
          .read = [=](const FileValue& value) -> std::optional<std::vector<T>> {
            if (!check_names(value, shape)) {
              return std::nullopt;
            }
            const int errors_before = value.found.error_count();
            std::vector<T> elements;
            elements.reserve(count_whole(value.node, element.shape));
            for (const YamlEntry& entry : value.node.entries) {
              const Name given{.text = entry.key, .where = entry.key_where};
              check_element_name(given, shape, value.found);
              if (auto one = element.read(element_of(value, entry, title))) {
                set(elements.emplace_back(), *std::move(one));
                elements.back().*name = given;
              }
            }
            return value.found.error_count() == errors_before ? std::optional(std::move(elements))
                                                              : std::nullopt;
          },
          .write =
              [=](const std::vector<T>& elements) {
                FileText text{.kind = FileText::Kind::mapping};
                text.in_lines = is_mapping(element.shape);
                for (const T& one : elements) {
                  text.entries.emplace_back(element_key(one.*name, shape), element.write(get(one)));
                }
                return text;
              }};
}

/// A mapping of names to descriptions: "load '{0}'".
template <class T>
Form<std::vector<T>> named(Name T::*name,
                           const Form<T>& element,
                           const FormShape& shape,
                           const std::string& title) {
  return by_name(
      name,
      element,
      shape,
      title,
      [](T& one, T&& given) { one = std::move(given); },
      [](const T& one) -> const T& { return one; });
}

/// A mapping of names to single values.
template <class T, class Value, class NameMember>
Form<std::vector<T>> values_by_name(NameMember T::*name,
                                    Value T::*value,
                                    const Form<Value>& form,
                                    const FormShape& shape,
                                    const std::string& title) {
  return by_name(
      name,
      form,
      shape,
      title,
      [value](T& one, Value&& given) { one.*value = std::move(given); },
      [value](const T& one) -> const Value& { return one.*value; });
}

}  // namespace kinestat
