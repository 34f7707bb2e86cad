// The keys of a mapping while they are declared; to be included through forms/mapping.hpp.
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "forms/lazy.hpp"
#include "forms/mapping.hpp"

namespace kinestat {

/// The rest of a key's declaration.
template <class T>
class Mapping<T>::Key {
 public:
  Key(Mapping& mapping, FormKey key) : mapping_(mapping), key_(std::move(key)) {}

  /// The key must be there.
  template <class Member, class Value>
  Key& needed(Member T::*member, const Form<Value>& form, std::string_view example = {}) {
    key_.is_needed = true;
    return may(member, form, example);
  }

  /// It may be left out.
  template <class Member, class Value>
  Key& may(Member T::*member, const Form<Value>& form, std::string_view example = {}) {
    mapping_.add_member(with(form.shape, example),
                        member,
                        kMemberOps<Member, Value>,
                        form.read.any(),
                        form.write.any());
    return *this;
  }

  /// Likewise, by what is made once a file has the key: a form, or a mapping.
  template <class Member, std::invocable Make>
  Key& may(Member T::*member, Make make, std::string_view example = {}) {
    return may_lazily(member, Lazy([make] { return form_of(make()); }), example);
  }

  /// A list of two, which must be there, by a form of each.
  template <class Member>
  Key& pair(Member T::*first,
            Member T::*second,
            const Form<Member>& form,
            std::string_view example,
            std::string_view hint);

  /// Likewise, by a form of both.
  template <class Member>
  Key& pair(Member T::*first,
            Member T::*second,
            const Form<std::vector<Member>>& list,
            std::string_view example);

  /// It must be there, but is not written as long as it says what is usual.
  Key& required(Absence absence = {}) {
    mapping_.last_key().is_needed = true;
    mapping_.last_key().absence = absence;
    return *this;
  }

  /// Keys of the same object in a mapping of their own, or those of a member.
  Key& group(const Mapping& part);
  template <class Member>
  Key& group(Member T::*member, const Mapping<Member>& part);

  /// It is checked, but not kept; `written` stands for what was read.
  template <class Value>
  Key& passed_over(const Form<Value>& form,
                   std::string_view example,
                   std::optional<Value> written = {});

  /// In a way of its own; what is written is empty where the key is left out.
  Key& by(Lazy<FormShape> shape,
          std::function<void(const FileValue&, T&)> read,
          std::function<std::optional<FileText>(const T&)> write,
          std::string_view example = {});

  /// The member says whether the key is there; then it is written even if there is nothing in it.
  Key& noted(bool T::*is_there) {
    mapping_.also_note(is_there);
    return *this;
  }

  /// The key is there iff the member has this value.
  template <class Member>
  Key& selects(Member T::*member, Member chosen);

  /// Where the key stands, or its value if it is no section.
  Key& at(SourceRange T::*place) {
    mapping_.also_place(place, false);
    return *this;
  }

  /// Where the value stands.
  Key& at_value(SourceRange T::*place) {
    mapping_.also_place(place, true);
    return *this;
  }

  /// What to add where it is missing.
  Key& add_hint(std::string_view hint) {
    mapping_.last_key().missing = hint;
    return *this;
  }

  /// What holds if it is left out.
  Key& usual(std::string_view value) {
    mapping_.last_key().usual = value;
    return *this;
  }

  /// Another example.
  Key& example(std::string_view text) {
    mapping_.last_key().examples.push_back(text);
    return *this;
  }

  /// A value that an editor offers.
  Key& offer(std::string_view value, std::string_view meaning) {
    mapping_.last_key().suggestions.push_back({.value = value, .meaning = meaning});
    return *this;
  }

 private:
  template <class Member, class Value>
  Key& may_lazily(Member T::*member, const Lazy<Form<Value>>& form, std::string_view example);

  FormKey with(Lazy<FormShape> shape, std::string_view example) {
    key_.shape = std::move(shape);
    if (!example.empty()) {
      key_.examples.push_back(example);
    }
    return std::move(key_);
  }

  Mapping& mapping_;
  FormKey key_;
};

}  // namespace kinestat
