#include "math/sampling/permutation.hpp"

#include <bit>
#include <utility>

#include "core/contract.hpp"

namespace kinestat {

namespace {

// The last step of SplitMix64 (Steele, Lea and Flood 2014): each bit moves half of the others.
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

std::uint64_t lowest(unsigned bits) {
  return (std::uint64_t{1} << bits) - 1;
}

}  // namespace

Permutation::Permutation(std::uint64_t size, const CounterBasedRandom& bits, std::uint64_t stream)
    : size_(size) {
  KINESTAT_EXPECTS(size >= 1);
  const auto width = static_cast<unsigned>(std::bit_width(size - 1));
  high_bits_ = width / 2;
  low_bits_ = width - high_bits_;
  for (std::size_t i = 0; i < kRounds; ++i) {
    keys_[i] = bits.at(stream, i);
  }
}

std::uint64_t Permutation::at(std::uint64_t index) const {
  do {
    index = mapped(index);
  } while (index >= size_);
  return index;
}

// Each round changes one half by the other and exchanges them.
std::uint64_t Permutation::mapped(std::uint64_t number) const {
  std::uint64_t one = number >> low_bits_;
  std::uint64_t other = number & lowest(low_bits_);
  unsigned bits_of_one = high_bits_;
  unsigned bits_of_other = low_bits_;
  for (const std::uint64_t key : keys_) {
    one ^= mixed(other + key) & lowest(bits_of_one);
    std::swap(one, other);
    std::swap(bits_of_one, bits_of_other);
  }
  return one << low_bits_ | other;
}

}  // namespace kinestat
