// Items of a report by the hashes of their places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kinestat {

/// Finds an item among millions at the cost of a cache miss: the hashes stand in one table, each in
/// the first slot that was free from its own on. Several items may have one hash.
class PlaceIndex {
 public:
  void add(std::size_t hash, std::uint32_t item) {
    if (slots_.size() <= 2 * count_) {
      grow();
    }
    put({.hash = static_cast<std::uint32_t>(hash), .item = item});
    ++count_;
  }

  /// How many items there are.
  std::size_t count() const { return count_; }

  /// The item with that hash that is the one; `is_the_one` is asked of each.
  template <typename IsTheOne>
  std::optional<std::uint32_t> find(std::size_t hash, IsTheOne is_the_one) const {
    const auto wanted = static_cast<std::uint32_t>(hash);
    for (std::size_t i = first_slot(wanted); !slots_.empty() && slots_[i].item != kFree;
         i = slot_after(i)) {
      if (slots_[i].hash == wanted && is_the_one(slots_[i].item)) {
        return slots_[i].item;
      }
    }
    return {};
  }

 private:
  static constexpr std::uint32_t kFree = UINT32_MAX;
  static constexpr std::size_t kFewestSlots = 64;

  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t item = kFree;
  };

  // There are a power of two of slots.
  std::size_t first_slot(std::uint32_t hash) const { return hash & (slots_.size() - 1); }

  std::size_t slot_after(std::size_t i) const { return (i + 1) & (slots_.size() - 1); }

  void put(Slot slot) {
    std::size_t i = first_slot(slot.hash);
    while (slots_[i].item != kFree) {
      i = slot_after(i);
    }
    slots_[i] = slot;
  }

  void grow() {
    std::vector<Slot> before(slots_.empty() ? kFewestSlots : 2 * slots_.size());
    before.swap(slots_);
    for (const Slot& slot : before) {
      if (slot.item != kFree) {
        put(slot);
      }
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace kinestat
