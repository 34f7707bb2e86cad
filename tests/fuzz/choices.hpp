// Bytes of a fuzzer as a row of decisions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kinestat::fuzz {

class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool are_used_up() const { return bytes_.empty(); }

  /// An index below `count`; 0 once the bytes are used up.
  std::size_t below(std::size_t count) {
    std::size_t number = 0;
    for (std::size_t reach = 1; reach < count && !bytes_.empty(); reach *= 256) {
      number = 256 * number + bytes_.front();
      bytes_ = bytes_.subspan(1);
    }
    return count > 0 ? number % count : 0;
  }

  /// One of a list, which is not empty.
  template <typename List>
  auto& of(List& list) {
    return list[below(list.size())];
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace kinestat::fuzz
