// Members and lists of any type, so that what reads and writes them is compiled once.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace kinestat {

/// A member of objects, whatever their types.
class AnyMember {
 public:
  template <class T, class Member>
  AnyMember(Member T::*member) : find_(find<T, Member>) {
    static_assert(sizeof member == sizeof pointer_);
    std::memcpy(pointer_.data(), &member, sizeof member);
  }

  void* of(void* object) const { return find_(pointer_.data(), object); }

  const void* of(const void* object) const {
    return find_(pointer_.data(), const_cast<void*>(object));
  }

 private:
  template <class T, class Member>
  static void* find(const std::byte* pointer, void* object) {
    Member T::*member = nullptr;
    std::memcpy(&member, pointer, sizeof member);
    return &(static_cast<T*>(object)->*member);
  }

  std::array<std::byte, sizeof(int AnyMember::*)> pointer_{};
  void* (*find_)(const std::byte* pointer, void* object);
};

/// What can be done with a vector of any items.
struct ListOps {
  std::size_t (*size)(const void* list);
  void* (*item)(void* list, std::size_t index);
  void (*reserve)(void* list, std::size_t count);
  void* (*add)(void* list);  ///< an item at the end
  void (*drop_last)(void* list);

  const void* item_of(const void* list, std::size_t index) const {
    return item(const_cast<void*>(list), index);
  }
};

template <class T>
inline constexpr ListOps kListOps = {
    .size = [](const void* list) { return static_cast<const std::vector<T>*>(list)->size(); },
    .item = [](void* list, std::size_t index) -> void* {
      return &(*static_cast<std::vector<T>*>(list))[index];
    },
    .reserve = [](void* list,
                  std::size_t count) { static_cast<std::vector<T>*>(list)->reserve(count); },
    .add = [](void* list) -> void* { return &static_cast<std::vector<T>*>(list)->emplace_back(); },
    .drop_last = [](void* list) { static_cast<std::vector<T>*>(list)->pop_back(); }};

}  // namespace kinestat
