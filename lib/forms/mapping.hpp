// A mapping of a mechanism file, declared once: its keys and how they belong together.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "forms/any_mapping.hpp"
#include "forms/collections.hpp"
#include "forms/form.hpp"
#include "forms/member.hpp"

namespace kinestat {

/// What is read into a T. The declaration is made by the function given to the constructor:
///
///     m.key("to", "Where the motion ends, measured from the drawn position.")
///         .needed(&DriveRange::to, drawn_position(), "360 deg");
template <class T>
class Mapping : public AnyMapping {
 public:
  class Key;

  /// The definition is the name of the mapping in the schema; empty: it is written where it stands.
  template <class Declare>
  Mapping(std::string_view definition,
          std::string_view meaning,
          std::string_view example,
          Declare declare)
      : AnyMapping(definition, meaning, example, place_member(), usual) {
    declare(*this);
    close();
  }

  Mapping(Mapping&&) = default;

  /// Begins the declaration of a key; the meaning is a sentence.
  Key key(std::string_view name, std::string_view meaning) {
    return Key(*this, {.key = name, .meaning = meaning});
  }

  /// What else must hold, once all keys are read.
  void check(std::function<void(const T&, const FileValue&)> check) {
    add_check([check = std::move(check)](const void* object, const FileValue& value) {
      check(*static_cast<const T*>(object), value);
    });
  }

  /// The keys of an item stand in this mapping itself if there is one item; several are the list
  /// behind `list_key`, with that title of each. In the list they may have a mapping of their own.
  template <class Item>
  void one_or_several(const Mapping<Item>& item,
                      std::vector<Item> T::*member,
                      FormKey list_key,
                      std::string_view title,
                      std::string_view hint,
                      const Mapping<Item>* of_list = nullptr) {
    SharedList<std::string_view> replaced;
    for (const FormKey& key : item.shape().keys) {
      replaced.push_back(key.key);
    }
    instead(list_key.key, std::move(replaced), hint);
    const Mapping<Item>& listed = of_list != nullptr ? *of_list : item;
    const auto list = list_of(listed.form(), std::string(title), std::string(hint));
    add_one_or_several(item, member, kListOps<Item>, std::move(list_key), any_of(list));
  }

  /// The value as a mapping. Empty iff an error was added.
  std::optional<T> read(const FileValue& value) const {
    T object;
    return any_read(&object, value) ? std::optional(std::move(object)) : std::nullopt;
  }

  /// False iff an error was added. Where the object stands is not noted.
  bool read_into(T& object, const FileValue& value) const { return any_read_into(&object, value); }

  /// Without the keys that are as they would be if left out.
  FileText text(const T& object) const { return any_text(&object); }

  /// The same; empty if all keys are left out.
  std::optional<FileText> text_if_any(const T& object) const { return any_text_if_any(&object); }

  Form<T> form() const { return form_of_a<T>(any_form()); }

 private:
  static std::optional<AnyMember> place_member() {
    if constexpr (HasPlace<T>) {
      return &T::where;
    } else {
      return std::nullopt;
    }
  }

  static const void* usual() {
    static const T object{};
    return &object;
  }
};

template <class T>
const Form<T>& form_of(const Form<T>& form) {
  return form;
}

template <class T>
Form<T> form_of(const Mapping<T>& mapping) {
  return mapping.form();
}

}  // namespace kinestat

#include "forms/mapping_key.hpp"
#include "forms/mapping_parts.hpp"
