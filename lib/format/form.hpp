// How a value is written in a mechanism file: read from it, written to it, and told in the schema.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostic.hpp"
#include "format/form_shape.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// A value of the file while it is read.
struct FileValue {
  const YamlNode& node;
  std::string what;            ///< in messages: "'trace' of 'motion'"; empty: the file itself
  std::string key;             ///< "trace"
  std::string owner;           ///< the mapping that has the key: "'motion'"
  SourceRange where;           ///< of a mapping: where it says that a key is missing
  SourceRange place;           ///< where a section begins: at its key
  std::optional<Space> space;  ///< empty after an error: then nothing is read that needs it
  Diagnostics& found;
};

/// `read` answers empty iff it added an error.
template <class T>
struct Form {
  FormShape shape;
  std::function<std::optional<T>(const FileValue&)> read;
  std::function<std::string(const T&)> write;
};

/// An item of a list; `title` names it in messages: "trace point {0}", "station {0} of {1}", with
/// its number from 1 and the owner of the list.
FileValue item_of(const FileValue& list, std::size_t index, const std::string& title);

/// Whether the value is a list of as many items as the shape says; adds an error with the hint if
/// not, by default a sketch of the list.
bool check_items(const FileValue& value, const FormShape& shape, const std::string& hint);

/// "[a, b]".
std::string in_brackets(const std::vector<std::string>& items);

/// "{drive: in, to: 90 deg}".
std::string in_braces(const std::vector<std::pair<std::string, std::string>>& entries);

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
            std::vector<std::string> texts;
            for (const T& one : items) {
              texts.push_back(item.write(one));
            }
            return in_brackets(texts);
          }};
}

/// One item, or a list of them.
template <class T>
Form<std::vector<T>> one_or_more(const Form<T>& item, std::size_t least = 0) {
  const auto list = list_of(item, "", "", {.least = least});
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

}  // namespace kinestat
