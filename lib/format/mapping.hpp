// A mapping of a mechanism file, declared once: its keys and how they belong together.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "format/collections.hpp"
#include "format/form.hpp"
#include "format/mapping_check.hpp"
#include "format/member.hpp"
#include "io/fields.hpp"

namespace kinestat {

/// What is read into a T. The declaration is made by the function given to the constructor:
///
///     m.key("to", "Where the motion ends, measured from the drawn position.")
///         .needed(&DriveRange::to, drawn_position(), "360 deg");
template <class T>
class Mapping {
 public:
  class Key;

  /// The definition is the name of the mapping in the schema; empty: it is written where it stands.
  template <class Declare>
  Mapping(std::string_view definition,
          std::string_view meaning,
          std::string_view example,
          Declare declare) {
    shape_ = {.kind = FormKind::mapping, .definition = definition, .meaning = meaning};
    if (!example.empty()) {
      shape_.examples.push_back(example);
    }
    declare(*this);
  }

  Mapping(Mapping&&) = default;

  /// Begins the declaration of a key; the meaning is a sentence.
  Key key(std::string_view name, std::string_view meaning) {
    return Key(*this, {.key = name, .meaning = meaning});
  }

  /// `key` stands instead of `others`.
  void instead(std::string_view key, SharedList<std::string_view> others, std::string_view hint) {
    shape_.rules.push_back({.kind = FormRule::Kind::instead,
                            .key = key,
                            .others = std::move(others),
                            .message = "{} cannot have '{}' together with '{}'",
                            .hint = hint});
  }

  void rule(FormRule rule) { shape_.rules.push_back(std::move(rule)); }

  /// Keys that begin like this one are the user's own and pass unread.
  void own_keys(FormKey beginning) { shape_.beginnings.push_back(std::move(beginning)); }

  /// What else must hold, once all keys are read.
  void check(std::function<void(const T&, const FileValue&)> check) {
    checks_.push_back(std::move(check));
  }

  /// The keys of an item stand in this mapping itself if there is one item; several are the list
  /// behind `list_key`, with that title of each. In the list they may have a mapping of their own.
  template <class Item>
  void one_or_several(const Mapping<Item>& item,
                      std::vector<Item> T::*member,
                      FormKey list_key,
                      std::string_view title,
                      std::string_view hint,
                      const Mapping<Item>* of_list = nullptr);

  void example(std::string_view text) { shape_.examples.push_back(text); }  ///< another

  void may_be_empty() { shape_.may_be_empty = true; }  ///< nothing need stand behind its name

  void write_in_lines() { is_in_lines_ = true; }  ///< a line for each key

  const FormShape& shape() const { return shape_; }

  /// The value as a mapping, in which other keys may be `known`. Empty iff an error was added.
  std::optional<T> read(const FileValue& value,
                        const SharedList<std::string_view>& known = {}) const {
    T object;
    if constexpr (HasPlace<T>) {
      object.where = value.place;
    }
    return read_into(object, value, known) ? std::optional(std::move(object)) : std::nullopt;
  }

  /// False iff an error was added.
  bool read_into(T& object,
                 const FileValue& value,
                 const SharedList<std::string_view>& known = {}) const;

  /// Without the keys that are as they would be if left out.
  FileText text(const T& object) const;

  /// The same; empty if all keys are left out.
  std::optional<FileText> text_if_any(const T& object) const;

  Form<T> form() const;

 private:
  template <class>
  friend class Mapping;

  struct Step {
    std::function<void(const FileValue&, T&)> read;
    std::function<std::optional<FileText>(const T&)> write;  // empty: the key is left out
  };

  FormShape shape_;
  bool is_in_lines_ = false;
  std::vector<Step> steps_;  // of the keys
  std::vector<std::function<void(const T&, const FileValue&)>> checks_;
};

}  // namespace kinestat

#include "format/mapping_groups.hpp"
#include "format/mapping_key.hpp"
#include "format/mapping_members.hpp"
#include "format/mapping_parts.hpp"
