// Members of descriptions while a key is read into them or written from them.
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "description/value.hpp"
#include "forms/form.hpp"

namespace kinestat {

/// Whether a description remembers where it stands in the file.
template <class T>
concept HasPlace = requires(T object) {
  { object.where } -> std::same_as<SourceRange&>;
};

template <class Member, class T>
void set_member(Member& member, T&& value) {
  member = std::forward<T>(value);
}

template <class T>
void set_member(std::shared_ptr<const T>& member, T&& value) {
  member = std::make_shared<const T>(std::forward<T>(value));
}

/// What is to be written of a member, or null: `usual` is the member of what the file says nothing
/// about.
template <class T>
const T* present(const std::optional<T>& member, const std::optional<T>&, bool) {
  return member ? &*member : nullptr;
}

template <class T>
const T* present(const std::shared_ptr<const T>& member, const std::shared_ptr<const T>&, bool) {
  return member.get();
}

template <class T>
const std::vector<T>* present(const std::vector<T>& member, const std::vector<T>&, bool is_needed) {
  return is_needed || !member.empty() ? &member : nullptr;
}

/// A name is there if it has a text.
inline const Name* present(const Name& member, const Name&, bool is_needed) {
  return is_needed || !member.text.empty() ? &member : nullptr;
}

template <class T>
const T* present(const T& member, const T& usual, bool is_needed) {
  if constexpr (std::equality_comparable<T>) {
    return is_needed || member != usual ? &member : nullptr;
  } else {
    return &member;
  }
}

/// What is done with a member by a form, whatever their types.
struct MemberOps {
  void (*read)(const AnyRead& read, const FileValue& value, void* member);
  const void* (*present)(const void* member, const void* usual, bool is_needed);
};

template <class Member, class Value>
inline constexpr MemberOps kMemberOps = {
    .read =
        [](const AnyRead& read, const FileValue& value, void* member) {
          Value one{};
          if (read(value, &one)) {
            set_member(*static_cast<Member*>(member), std::move(one));
          }
        },
    .present = [](const void* member, const void* usual, bool is_needed) -> const void* {
      const Value* const one = present(
          *static_cast<const Member*>(member), *static_cast<const Member*>(usual), is_needed);
      return one;
    }};

}  // namespace kinestat
