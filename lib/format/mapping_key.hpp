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
    mapping_.shape_.keys.push_back(std::move(key_));
    mapping_.steps_.push_back({.read =
                                   [member, read = form.read](const FileValue& value, T& object) {
                                     if (auto one = read(value)) {
                                       set_member(object.*member, *std::move(one));
                                     }
                                   },
                               .write = [member, write = form.write, is_needed = added().is_needed](
                                            const T& object) -> std::optional<std::string> {
                                 const auto* one = present(object.*member, T{}.*member, is_needed);
                                 return one != nullptr ? std::optional(write(*one)) : std::nullopt;
                               }});
    return *this;
  }

  /// What holds if it is left out.
  Key& usual(std::string value) {
    added().usual = std::move(value);
    return *this;
  }

  /// A value that an editor offers.
  Key& offer(std::string value, std::string meaning) {
    added().suggestions.push_back({.value = std::move(value), .meaning = std::move(meaning)});
    return *this;
  }

 private:
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
