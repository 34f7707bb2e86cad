// The keys of a mapping while they are declared; to be included through format/mapping.hpp.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "format/mapping.hpp"
#include "format/member.hpp"

namespace kinestat {

/// The rest of a key's declaration.
template <class T>
class Mapping<T>::Key {
 public:
  Key(Mapping& mapping, FormKey key) : mapping_(mapping), key_(std::move(key)) {}

  /// The key must be there.
  template <class Member, class Read>
  Key& needed(Member T::*member, const Form<Read>& form, std::string example = {}) {
    key_.is_needed = true;
    return may(member, form, std::move(example));
  }

  /// It may be left out.
  template <class Member, class Read>
  Key& may(Member T::*member, const Form<Read>& form, std::string example = {}) {
    key_.shape = form.shape;
    if (!example.empty()) {
      key_.examples.push_back(std::move(example));
    }
    const bool is_needed = key_.is_needed;
    add({.read =
             [member, read = form.read](const FileValue& value, T& object) {
               if (auto one = read(value)) {
                 set_member(object.*member, *std::move(one));
               }
             },
         .write =
             [member, write = form.write, is_needed](const T& object) -> std::optional<FileText> {
           const auto* one = present(object.*member, T{}.*member, is_needed);
           return one != nullptr ? std::optional(write(*one)) : std::nullopt;
         }});
    return *this;
  }

  /// A list of two, which must be there.
  template <class Member>
  Key& pair(Member T::*first,
            Member T::*second,
            const Form<Member>& form,
            std::string example,
            const std::string& hint) {
    const auto list = list_of(form, "", hint, {.least = 2, .most = 2});
    key_.shape = list.shape;
    key_.examples.push_back(std::move(example));
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

  /// It must be there, but is not written as long as it says what is usual.
  Key& required() {
    added().is_needed = true;
    return *this;
  }

  /// Keys of the same object in a mapping of their own.
  Key& group(const Mapping& part) {
    key_.shape = part.shape_;
    add({.read = [&part](const FileValue& value, T& object) { part.read_into(object, value); },
         .write = [&part](const T& object) -> std::optional<FileText> {
           FileText text = part.text(object);
           return text.entries.empty() ? std::nullopt : std::optional(std::move(text));
         }});
    return *this;
  }

  /// It is checked, but not kept.
  template <class Read>
  Key& passed_over(const Form<Read>& form, std::string example) {
    key_.shape = form.shape;
    key_.examples.push_back(std::move(example));
    add({.read = [read = form.read](const FileValue& value, T&) { (void)read(value); },
         .write = [](const T&) { return std::optional<FileText>(); }});
    return *this;
  }

  /// The member says whether the key is there; then it is written even if there is nothing in it.
  Key& noted(bool T::*is_there) {
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

  /// The key is there iff the member has this value.
  template <class Member>
  Key& selects(Member T::*member, Member chosen) {
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

  /// Where the key stands, or its value if it is no section.
  Key& at(SourceRange T::*place) {
    return placed(place, [](const FileValue& value) { return value.place; });
  }

  /// Where the value stands.
  Key& at_value(SourceRange T::*place) {
    return placed(place, [](const FileValue& value) { return value.node.where; });
  }

  /// What to add where it is missing.
  Key& add_hint(std::string hint) {
    added().missing = std::move(hint);
    return *this;
  }

  /// What holds if it is left out.
  Key& usual(std::string value) {
    added().usual = std::move(value);
    return *this;
  }

  /// Another example.
  Key& example(std::string text) {
    added().examples.push_back(std::move(text));
    return *this;
  }

  /// A value that an editor offers.
  Key& offer(std::string value, std::string meaning) {
    added().suggestions.push_back({.value = std::move(value), .meaning = std::move(meaning)});
    return *this;
  }

 private:
  void add(Step step) {
    mapping_.shape_.keys.push_back(std::move(key_));
    mapping_.steps_.push_back(std::move(step));
  }

  template <class Place>
  Key& placed(SourceRange T::*member, Place place) {
    Step& step = mapping_.steps_.back();
    step.read = [member, place, read = step.read](const FileValue& value, T& object) {
      object.*member = place(value);
      read(value, object);
    };
    return *this;
  }

  FormKey& added() { return mapping_.shape_.keys.back(); }

  Mapping& mapping_;
  FormKey key_;
};

template <class T>
template <class Item>
void Mapping<T>::one_or_several(const Mapping<Item>& item,
                                std::vector<Item> T::*member,
                                FormKey list_key,
                                const std::string& title,
                                const std::string& hint) {
  std::vector<std::string> replaced;
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
  const auto list = list_of(item.form(), title, hint);
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
