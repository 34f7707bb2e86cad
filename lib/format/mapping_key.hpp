// The keys of a mapping while they are declared; to be included through format/mapping.hpp.
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
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
  Key& needed(Member T::*member, const Form<Read>& form, std::string_view example = {}) {
    key_.is_needed = true;
    return may(member, form, example);
  }

  /// It may be left out.
  template <class Member, class Read>
  Key& may(Member T::*member, const Form<Read>& form, std::string_view example = {});

  /// Likewise, by what is made once a file has the key: a form, or a mapping.
  template <class Member, std::invocable Make>
  Key& may(Member T::*member, Make make, std::string_view example = {});

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
    added().is_needed = true;
    added().absence = absence;
    return *this;
  }

  /// Keys of the same object in a mapping of their own, or those of a member.
  Key& group(const Mapping& part);
  template <class Member>
  Key& group(Member T::*member, const Mapping<Member>& part);

  /// It is checked, but not kept; `written` stands for what was read.
  template <class Read>
  Key& passed_over(const Form<Read>& form,
                   std::string_view example,
                   std::optional<Read> written = {});

  /// In a way of its own; what is written is empty where the key is left out.
  Key& by(Lazy<FormShape> shape,
          std::function<void(const FileValue&, T&)> read,
          std::function<std::optional<FileText>(const T&)> write,
          std::string_view example = {});

  /// The member says whether the key is there; then it is written even if there is nothing in it.
  Key& noted(bool T::*is_there);

  /// The key is there iff the member has this value.
  template <class Member>
  Key& selects(Member T::*member, Member chosen);

  /// Where the key stands, or its value if it is no section.
  Key& at(SourceRange T::*place) {
    return placed(place, [](const FileValue& value) { return value.place; });
  }

  /// Where the value stands.
  Key& at_value(SourceRange T::*place) {
    return placed(place, [](const FileValue& value) { return value.node.where; });
  }

  /// What to add where it is missing.
  Key& add_hint(std::string_view hint) {
    added().missing = hint;
    return *this;
  }

  /// What holds if it is left out.
  Key& usual(std::string_view value) {
    added().usual = value;
    return *this;
  }

  /// Another example.
  Key& example(std::string_view text);

  /// A value that an editor offers.
  Key& offer(std::string_view value, std::string_view meaning) {
    added().suggestions.push_back({.value = value, .meaning = meaning});
    return *this;
  }

 private:
  template <class Part, class Get>
  Key& group(const Mapping<Part>& part, Get get);

  template <class Member, class Read, class Write>
  Key& kept(
      Member T::*member, Lazy<FormShape> shape, Read read, Write write, std::string_view example);

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

}  // namespace kinestat
