// Random bits by their number.
#pragma once

#include <array>
#include <cstdint>

namespace kinestat {

/// Philox 4x32 with ten rounds (Salmon, Moraes, Dror and Shaw 2011): four words that a counter and
/// a key make, by integer arithmetic alone, so that they are the same on every machine.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// Many streams of random words of 64 bits, of which any is there without those before it.
class CounterBasedRandom {
 public:
  explicit CounterBasedRandom(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t at(std::uint64_t stream, std::uint64_t index) const;

 private:
  std::uint64_t seed_;
};

}  // namespace kinestat
